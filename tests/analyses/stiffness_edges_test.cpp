// Stiffnesses and lengths that differ by up to twelve orders of magnitude, against exact values.
#include <fmt/format.h>

#include <catch2/catch.hpp>

#include "deck/decks.hpp"
#include "tools/static_run.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

std::string section(const std::string& name, double EA, double EI) {
    return fmt::format(
        "[section.{0}]\nstiffness = {{ EA = {1:g}, GAy = {1:g}, GAz = {1:g}, GJ = {2:g}, EIy = {2:g}, EIz = "
        "{2:g} }}\n",
        name,
        EA,
        EI);
}

std::string rod(const std::string& name, const std::string& section, double from, double to, int elements) {
    return fmt::format(
        "[rod.{}]\nsection = \"{}\"\nline = {{ from = [{:.17g}, 0, 0], to = [{:.17g}, 0, 0] }}\nelements = "
        "{}\norder = 2\n",
        name,
        section,
        from,
        to,
        elements);
}

const std::string clamped =
    "[[support]]\nat = \"r.start\"\nfix = \"all\"\n[analysis]\nkind = \"static\"\nsteps = 1\n";

std::string load(const std::string& at, double force) {
    return fmt::format("[[load]]\nat = \"{}\"\nforce = [0, 0, {:g}]\n", at, force);
}

StaticRun run(const std::string& deck) {
    return run_static(test::read(deck).model, make_static_settings(1, 1e-8));
}

}  // namespace

TEST_CASE("A rod bends alike however little it stretches", "[analyses][static]") {
    constexpr double P = 1e-6;
    for (const double EA : {1e3, 1e6, 1e9, 1e12}) {
        INFO(EA);
        const StaticRun found =
            run(section("s", EA, 1.0) + rod("r", "s", 0.0, 1.0, 4) + clamped + load("r.end", P));
        const double exact = P / 3.0 + P / EA;
        CHECK(found.tip().r.z() == Approx(exact).epsilon(EA < 1e10 ? 1e-10 : 1e-5));
    }
}

TEST_CASE("Rods in a row bend as their stiffnesses say, up to where round-off is warned of",
          "[analyses][static]") {
    for (const double ratio : {1e-12, 1e-6, 1e6}) {
        INFO(ratio);
        const double P = 1e-8 * std::min(ratio, 1.0);
        const StaticRun found =
            run(section("a", 1e4, 1.0) + section("b", 1e4 * ratio, ratio) + rod("r", "a", 0.0, 1.0, 3) +
                rod("q", "b", 1.0, 2.0, 3) + "[[connect]]\npoints = [\"r.end\", \"q.start\"]\n" + clamped +
                load("q.end", P));
        const double exact = P * (7.0 / 3.0 + 1.0 / (3.0 * ratio) + 1e-4 * (1.0 + 1.0 / ratio));
        CHECK(found.tip().r.z() == Approx(exact).epsilon(1e-6));
    }
}

TEST_CASE("A rod of hardly any length changes nothing but its end", "[analyses][static]") {
    const auto tip_of = [](double length) {
        const std::string own = rod("r", "a", 0.0, 1.0, 4);
        const std::string more = length == 0.0 ? ""
                                               : rod("q", "a", 1.0, 1.0 + length, 1) +
                                                     "[[connect]]\npoints = [\"r.end\", \"q.start\"]\n";
        return run(section("a", 1e4, 1.0) + own + more + clamped +
                   load(more.empty() ? "r.end" : "q.end", 0.1))
            .tip()
            .r;
    };
    const Vec3 expected = tip_of(0.0);
    for (const double length : {1e-3, 1e-6, 1e-9}) {
        INFO(length);
        CHECK((tip_of(length) - expected).norm() < 1.01 * length + 1e-11);
    }
    // What is no length beside the coordinates is refused.
    CHECK_THAT(test::faults_of(section("a", 1e4, 1.0) + rod("r", "a", 1.0, 1.0 + 1e-13, 1) + clamped),
               Catch::Contains("the rod has no length"));
}
