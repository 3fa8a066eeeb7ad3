// Stiffnesses and lengths that differ by up to twelve orders of magnitude, against exact values.
#include <fmt/format.h>

#include <algorithm>

#include "analyses/dynamic.hpp"
#include "deck/decks.hpp"
#include "tools/catch.hpp"
#include "tools/static_run.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

std::string section(const std::string& name, double EA, double EI) {
    return fmt::format(
        "[section.{0}]\nstiffness = {{ EA = {1:g}, GAy = {1:g}, GAz = {1:g}, GJ = {2:g}, EIy = {2:g}, EIz = "
        "{2:g} }}\ninertia = {{ rhoA = 1, rhoJ = 2e-4, rhoIy = 1e-4, rhoIz = 1e-4 }}\n",
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

namespace {

const std::string joined = "[[connect]]\npoints = [\"r.end\", \"q.start\"]\n";

// A cantilever along 0 … 1 whose end carries a rod q, and this a load of 0.1 across.
std::string carrying(const std::string& sections, const std::string& rods) {
    return sections + rods + joined + clamped + load("q.end", 0.1);
}

std::string with_stiff_rod(double ratio) {
    return carrying(section("a", 1e4, 1.0) + section("b", 1e4 * ratio, ratio),
                    rod("r", "a", 0.0, 1.0, 3) + rod("q", "b", 1.0, 2.0, 3));
}

std::string with_short_rod(double length) {
    return carrying(section("a", 1e4, 1.0), rod("r", "a", 0.0, 1.0, 4) + rod("q", "a", 1.0, 1.0 + length, 1));
}

std::string without_rod() {
    return section("a", 1e4, 1.0) + rod("r", "a", 0.0, 1.0, 4) + clamped + load("r.end", 0.1);
}

StaticRun attempt(const std::string& deck) {
    return try_static(test::read(deck).model, make_static_settings(1, 1e-8));
}

// The reason that a failure gives, and what to try first.
std::string reason(const std::string& round_off, const std::string& part) {
    return "Likely because rod q is too stiff compared with what bends rod r for numbers of 16 digits: "
           "round-off of "
           "its forces is about " +
           round_off + ", a force that bends rod r about 1. Try EA, GAy and GAz up to " + part +
           " of what they are, or longer elements";
}

// The same pushed by a load that grows smoothly: a sudden one makes ends of hardly any mass whirl.
std::string in_motion(std::string deck) {
    deck = test::replaced(deck, "force = [0, 0, 0.1]", "force = [0, 0, \"0.1 * sin(pi * t / 2)^2\"]");
    return test::replaced(
        deck,
        "kind = \"static\"\nsteps = 1\n",
        "kind = \"dynamic\"\nend_time = 1.0\nsteps = 50\nintegrator = \"generalized-alpha\"\n");
}

// The stages of this scheme magnify what is left of an equilibrium.
std::string in_stages(const std::string& deck) {
    return test::replaced(in_motion(deck), "generalized-alpha", "sdirk-4");
}

// Of nodes along x; a mesh can list them from either end.
Vec3 find_tip(const State& state) {
    const auto nearer = [](const NodeMotion& a, const NodeMotion& b) { return a.r.x() < b.r.x(); };
    return std::max_element(state.trial.begin(), state.trial.end(), nearer)->r;
}

struct Motion {
    Vec3 tip;
    long steps = 0;
};

Motion run_motion(const std::string& deck) {
    const Problem problem = test::read(deck);
    DynamicAnalysis analysis(problem.model, test::dynamic_of(problem));
    REQUIRE(analysis.start().converged());
    Motion motion;
    for (; !analysis.finished(); ++motion.steps) {
        const EquilibriumReport report = analysis.advance();
        if (!report.converged()) FAIL(describe_failure(analysis.explain(report)));
    }
    motion.tip = find_tip(analysis.state());
    return motion;
}

// One line of elements of order 1 along x through these places.
std::string mesh_text(const std::vector<double>& places) {
    std::string nodes;
    std::string elements;
    for (std::size_t i = 0; i < places.size(); ++i) {
        nodes += fmt::format("{} {:.17g} 0 0\n", i + 1, places[i]);
        if (i > 0) elements += fmt::format("{} 1 2 1 1 {} {}\n", i + 2, i, i + 1);
    }
    return fmt::format(
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n3\n0 2 \"tip\"\n0 3 \"foot\"\n1 1 \"r\"\n"
        "$EndPhysicalNames\n$Nodes\n{0}\n{1}$EndNodes\n$Elements\n{2}\n1 15 2 3 1 1\n2 15 2 2 2 "
        "{0}\n{3}$EndElements\n",
        places.size(),
        nodes,
        places.size() + 1,
        elements);
}

std::string mesh_deck(const test::ScratchFile& mesh) {
    return section("a", 1e4, 1.0) +
           fmt::format("[rod.r]\nsection = \"a\"\nmesh = {{ file = \"{}\", group = \"r\" }}\n",
                       mesh.path().string()) +
           test::replaced(clamped, "r.start", "r.foot") + load("r.tip", 0.1);
}

}  // namespace

TEST_CASE("A rod that is 1e11 times as stiff as its neighbour is rigid", "[analyses][static]") {
    const Vec3 expected = attempt(with_stiff_rod(1e8)).tip().r;
    for (const double ratio : {1e9, 1e10, 1e11}) {
        INFO(ratio);
        const StaticRun found = attempt(with_stiff_rod(ratio));
        INFO(found.failure);
        REQUIRE(found.report.converged());
        CHECK(found.rejected_steps == 0);
        CHECK((found.tip().r - expected).norm() < 1e-8);
    }
}

TEST_CASE("A rod that is 1e12 times as stiff as its neighbour fails for round-off, soon",
          "[analyses][static]") {
    const StaticRun found = attempt(with_stiff_rod(1e12));
    CHECK_THAT(found.failure, Catch::Contains(reason("13", "0.0002")));
    CHECK_THAT(found.failure, !Catch::Contains("Nothing resists"));
    CHECK(found.rejected_steps < 200);
}

TEST_CASE("A rod of length 1e-12 at an end fails for round-off, soon", "[analyses][static]") {
    const StaticRun found = attempt(with_short_rod(1e-12));
    CHECK_THAT(found.failure, Catch::Contains(reason("2.2", "0.001")));
    CHECK_THAT(found.failure, !Catch::Contains("Nothing resists"));
    CHECK(found.rejected_steps < 200);
}

TEST_CASE("Stiff and short rods move as if rigid", "[analyses]") {
    const Motion rigid = run_motion(in_motion(with_stiff_rod(1e8)));
    for (const double ratio : {1e10, 1e12}) {
        INFO(ratio);
        const Motion found = run_motion(in_motion(with_stiff_rod(ratio)));
        CHECK(found.steps == 50);
        CHECK((found.tip - rigid.tip).norm() < 1e-8);
    }
    const Vec3 rigid_in_stages = run_motion(in_stages(with_stiff_rod(1e8))).tip;
    CHECK((run_motion(in_stages(with_stiff_rod(1e12))).tip - rigid_in_stages).norm() < 1e-8);
    const Motion alone = run_motion(in_motion(without_rod()));
    for (const double length : {1e-9, 1e-12}) {
        INFO(length);
        const Motion found = run_motion(in_motion(with_short_rod(length)));
        CHECK(found.steps == 50);
        CHECK((found.tip - alone.tip).norm() < 1e-9);
    }
}

TEST_CASE("An element of length 1e-12 within a mesh changes nothing", "[analyses][static]") {
    const test::ScratchFile even("even.msh", mesh_text({0.0, 0.25, 0.5, 0.75, 1.0}));
    const test::ScratchFile odd("odd.msh", mesh_text({0.0, 0.25, 0.5, 0.5 + 1e-12, 0.75, 1.0}));
    const StaticRun expected = run(mesh_deck(even));
    const StaticRun found = run(mesh_deck(odd));
    CHECK((find_tip(found.state) - find_tip(expected.state)).norm() < 1e-10);
    CHECK(found.rejected_steps == 0);
    CHECK((run_motion(in_motion(mesh_deck(odd))).tip - run_motion(in_motion(mesh_deck(even))).tip).norm() <
          1e-9);
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
    for (const double length : {1e-3, 1e-6, 1e-9, 1e-11}) {
        INFO(length);
        CHECK((tip_of(length) - expected).norm() < 1.01 * length + 1e-11);
    }
    // A length that vanishes compared with the coordinates is refused.
    CHECK_THAT(test::faults_of(section("a", 1e4, 1.0) + rod("r", "a", 1.0, 1.0 + 1e-13, 1) + clamped),
               Catch::Contains("the rod has no length"));
    CHECK_THAT(test::faults_of(section("a", 1e4, 1.0) +
                               "[rod.r]\nsection = \"a\"\npolyline = [[0, 0, 0], [0.5, 0, 0], "
                               "[0.500000000001, 0, 0], [1, 0, 0]]\nelements = 3\n" +
                               clamped),
               Catch::Contains("the same point as the one before"));
}
