#include "check/findings/unit_questions.hpp"

#include <fmt/format.h>

#include "deck/decks.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {

namespace {

// A steel rod under its weight, in m, kg and s; E, density and g as they are given.
std::vector<std::string> ask(const std::string& units, double E, double density, double g, double radius) {
    const std::string deck = fmt::format(
        "units = \"{}\"\ngravity = [0, 0, {}]\n[section.s]\nshape = {{ circle = {{ radius = {} }} "
        "}}\nmaterial = "
        "{{ E = {}, nu = 0.3, density = {} }}\n[rod.r]\nsection = \"s\"\nline = {{ from = [0, 0, 0], to = "
        "[{}, 0, 0] "
        "}}\nelements = 4\n[analysis]\nkind = \"static\"\n",
        units,
        -g,
        radius,
        E,
        density,
        50.0 * radius);
    const Problem problem = read(deck);
    std::vector<std::string> questions;
    for (const Finding& one : question_units(problem.model, problem.record.units))
        questions.push_back(one.message);
    return questions;
}

}  // namespace

TEST_CASE("Units are read in any order, masses by forces too", "[check]") {
    CHECK_FALSE(read_units(""));
    CHECK_FALSE(read_units("any consistent"));
    CHECK(read_units("mm t s")->length == 1e-3);
    CHECK(*read_units("mm t s")->mass == 1e3);
    CHECK(*read_units("m kN")->mass == 1e3);
    CHECK(*read_units("mm, N, ms")->mass == Approx(1e-3));  // 1 N = 1 kg m/s² = 1e-3 kg mm/ms²
    CHECK(read_units("mm, N, ms")->time == 1e-3);
    CHECK(*read_units("in lbf s")->mass == Approx(175.1268));
    CHECK_FALSE(read_units("m s")->mass);
}

TEST_CASE("Numbers in the units of the deck are not questioned", "[check]") {
    CHECK(ask("m kg s", 2.1e11, 7850, 9.81, 0.01).empty());
    CHECK(ask("mm t s", 2.1e5, 7.85e-9, 9810, 10).empty());
    CHECK(ask("mm kg ms", 210, 7.85e-6, 9.81e-3, 10).empty());
    CHECK(ask("in lbf s", 3e7, 7.3e-4, 386, 0.4).empty());
    CHECK(ask("any", 1.0, 1.0, 1.0, 1.0).empty());
}

TEST_CASE("Numbers in other units are questioned", "[check]") {
    const auto gravity = ask("mm t s", 2.1e5, 7.85e-9, 9.81, 10);
    REQUIRE(gravity.size() == 1);
    CHECK(gravity[0] == "gravity of 9.81 is 0.00981 m/s² in \"mm t s\"; that of the earth is 9810 there");
    const auto modulus = ask("mm t s", 2.1e11, 7.85e-9, 9810, 10);
    REQUIRE(modulus.size() == 1);
    CHECK(modulus[0] ==
          "stretching runs along section s at √(EA/ρA) = 5.17e+09, 5.17e+06 m/s in \"mm t s\" (of steel "
          "5.2e+03 m/s); "
          "are modulus and density in these units?");
    const auto density = ask("m kg s", 2.1e8, 7.85e6, 9.81, 0.01);
    REQUIRE(density.size() == 1);
    CHECK(density[0] ==
          "section s has a density of about 7.85e+06, 7.85e+06 kg/m³ in \"m kg s\"; water has 1e+03 there");
}

}  // namespace gxrod::test
