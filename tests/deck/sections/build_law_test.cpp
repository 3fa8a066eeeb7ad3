#include "deck/sections/build_sections.hpp"

#include <cmath>

#include "deck/decks.hpp"
#include "laws/fibre_law.hpp"
#include "laws/layered_law.hpp"
#include "laws/trapeze_law.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

using Catch::Contains;

std::string with_law(const std::string& law) {
    return replaced(rod_deck, "inertia = { rhoA", "law = { " + law + " }\ninertia = { rhoA");
}

std::string with_curve(const std::string& curve) { return with_law("moment_curvature = { " + curve + " }"); }

std::string of_shape(const std::string& shape) {
    return replaced(replaced(rod_deck,
                             "stiffness = { EA = 1e4, GAy = 2e4, GAz = 3e4, GJ = 500, EIy = 600, EIz = 700 }",
                             "shape = { " + shape + " }"),
                    "inertia = { rhoA = 1.0, rhoJ = 20, rhoIy = 10, rhoIz = 11 }",
                    "material = { E = 200, nu = 0.25, density = 1, yield_stress = 0.3 }");
}

const std::string layer = "layers = [{ on = \"bending\", stiffness = 100, limit = 5 }]";

}  // namespace

TEST_CASE("What is wrong with a fibre rope is reported with its place", "[deck]") {
    const std::string curve = "original = [[0, 0], [0.1, 60], [0.2, 80]], ";
    const std::string rest = "dynamic_stiffness = 2000, per_tension = 3, damping = 700";
    const auto faults = [](const std::string& rope) {
        return faults_of(with_law("syrope = { " + rope + " }"));
    };
    const std::string key = "section.s.law.syrope.";
    CHECK(faults(curve + "k1 = 0.25, k2 = 1.5, " + rest).empty());
    CHECK(faults(curve + "working_curve = \"linear\", k1 = 700, " + rest).empty());
    CHECK_THAT(faults("original = [[0, 1], [0.1, 60]], k1 = 0.2, k2 = 1, " + rest),
               Contains(key + "original[0]: expected [0, 0] first, found [0, 1]"));
    CHECK_THAT(faults("original = [[0, 0], [0.1, 60], [0.2, 60]], k1 = 0.2, k2 = 1, " + rest),
               Contains(key + "original[2]: expected a tension that rises from row to row"));
    CHECK_THAT(
        faults(curve + "k1 = 1, k2 = 1, " + rest),
        Contains(key + "k1: expected a number less than 1; from 1 on it is the slope of a linear curve"));
    CHECK_THAT(faults(curve + "k1 = 0.2, " + rest),
               Contains(key + "k2: missing; expected how much the working curve bends"));
    CHECK_THAT(faults(curve + "working_curve = \"quadratic\", k1 = 0.2, k2 = 1.1, " + rest),
               Contains(key + "k2: expected a number of at most 1: a quadratic curve falls otherwise"));
    CHECK_THAT(
        faults(curve + "k1 = 0.2, k2 = 1, dynamic_stiffness = 500, damping = 1"),
        Contains(key + "dynamic_stiffness: where the largest mean tension is 0 a curve rises by 600 per "
                       "strain, not less than the dynamic stiffness, 500; expected a stiffer rope, a "
                       "curve that bends less, or a greater largest_tension"));
    const std::string coupled = replaced(
        with_law("syrope = { " + curve + "k1 = 0.25, k2 = 1.5, " + rest + " }"),
        "stiffness = { EA = 1e4, GAy = 2e4, GAz = 3e4, GJ = 500, EIy = 600, EIz = 700 }",
        "stiffness_matrix = [[10000, 0, 0, 0, 50, 0], [0, 10000, 0, 0, 0, 0], [0, 0, 10000, 0, 0, 0], "
        "[0, 0, 0, 500, 0, 0], [50, 0, 0, 0, 600, 0], [0, 0, 0, 0, 0, 700]]");
    CHECK_THAT(
        faults_of(coupled),
        Contains(key + "original: the stiffness couples stretch with another strain, which a rope by "
                       "the Syrope model cannot; expected a stiffness without, such as stiffness = { … }"));
}

TEST_CASE("What is wrong with a law is reported with its place", "[deck]") {
    const auto faults = [](const std::string& law) { return faults_of(with_law(law)); };
    CHECK(faults_of(with_law(layer)).empty());
    CHECK_THAT(faults("layer = 1"),
               Contains("x.toml:3:9: section.s.law.layer: unknown key; did you mean \"layers\"?"));
    CHECK_THAT(faults("layers = [{ on = \"bend\", stiffness = 1, limit = 1 }]"),
               Contains("section.s.law.layers[0].on: expected one of \"bending\""));
    CHECK_THAT(faults("layers = [{ on = \"torsion\", stiffness = 1, limit = 0 }]"),
               Contains("section.s.law.layers[0].limit: expected a number greater than 0, or "
                        "limit_per_tension greater than 0, found 0"));
    CHECK_THAT(faults("layers = [{ on = \"tension\", stiffness = 1, limit = 2, limit_per_tension = 3 }]"),
               Contains("section.s.law.layers[0].limit_per_tension: a layer on tension has a limit that does "
                        "not depend on tension"));
    CHECK_THAT(faults("plastic = { yield = {} }"),
               Contains("section.s.law.plastic.yield: missing; expected N or Vy or Vz or T or My or Mz"));
    CHECK_THAT(faults("plastic = { yield = { My = 0 } }"),
               Contains("section.s.law.plastic.yield.My: expected a number greater than 0, found 0"));
    CHECK_THAT(faults("plastic = { yield = { My = 1 }, isotropic = [[0, 2], [1, 3]] }"),
               Contains("section.s.law.plastic.isotropic[0]: expected [0, 1] first, found [0, 2]"));
    CHECK_THAT(faults("viscoelastic = { prony = [[0.5, 1], [0.5, 0]] }"),
               Contains("section.s.law.viscoelastic.prony[1]: expected a time tau greater than 0, found 0"));
    CHECK_THAT(faults("viscoelastic = { prony = [[0.5, 1]] }, plastic = { yield = { My = 1 } }"),
               Contains("plastic is given too; only one of them can be"));
    CHECK_THAT(faults_of(replaced(rod_deck, "inertia = { rhoA", "trapeze = 1\ninertia = { rhoA")),
               Contains("section.s.trapeze: expected true or false, found 1"));
}

TEST_CASE("What is wrong with a table of moments is reported with its row", "[deck]") {
    const auto faults = [](const std::string& curve) { return faults_of(with_curve(curve)); };
    CHECK_THAT(faults("table = [[0.1, 5], [1, 6]]"),
               Contains("section.s.law.moment_curvature.table[0]: expected [0, 0] first, found [0.1, 5]"));
    CHECK_THAT(faults("table = [[0, 0]]"), Contains("table[0]: expected another row after the first one"));
    CHECK_THAT(faults("y = [[0, 0], [1, 5], [1, 6]]"),
               Contains("y[2]: the first number must rise from row to row: 1 follows 1"));
    CHECK_THAT(faults("y = [[0, 0], [1, 5], [2, 4]]"),
               Contains("y[2]: the second number must not fall from row to row: 4 follows 5"));
    CHECK_THAT(faults("z = [[0, 0], [1, 0], [2, 4]]"), Contains("z[1]: expected a moment greater than 0"));
    CHECK_THAT(
        faults("hysteresis = \"kinematic\", table = [[0, 0], [1, 1], [2, 3]]"),
        Contains("table[2]: a section that yields gets softer from row to row; the slope 2 follows 1"));
    CHECK_THAT(faults("table = [[0, 0], [1, 1]], y = [[0, 0], [1, 1]]"),
               Contains("y: table is given too; only one of them can be"));
    CHECK_THAT(faults("table = [[0, 0], [1]]"), Contains("table[1]: expected a row of 2 numbers"));
}

TEST_CASE("Laws that need stiffness without couplings say so", "[deck]") {
    const std::string coupled = replaced(
        rod_deck,
        "stiffness = { EA = 1e4, GAy = 2e4, GAz = 3e4, GJ = 500, EIy = 600, EIz = 700 }",
        "stiffness_matrix = [[9, 0, 0, 0, 1, 0], [0, 9, 0, 0, 0, 0], [0, 0, 9, 0, 0, 0], [0, 0, 0, 9, 0, 0], "
        "[1, 0, 0, 0, 9, 0], [0, 0, 0, 0, 0, 9]]\nlaw = { LAW }");
    const auto faults = [&](const std::string& law) { return faults_of(replaced(coupled, "LAW", law)); };
    CHECK_THAT(faults("moment_curvature = { table = [[0, 0], [1, 1]] }"),
               Contains("section.s.law.moment_curvature.table: the stiffness couples this bending"));
    CHECK(faults("moment_curvature = { z = [[0, 0], [1, 1]] }").empty());
    CHECK_THAT(faults("plastic = { yield = { N = 1, My = 1 }, interaction = \"none\" }"),
               Contains("section.s.law.plastic.interaction: the stiffness couples resultants that yield"));
    CHECK(faults("plastic = { yield = { N = 1, My = 1 } }").empty());
    CHECK(faults("plastic = { yield = { My = 1, Mz = 1 }, interaction = \"none\" }").empty());
    CHECK(faults(layer).empty());
}

TEST_CASE("Rods of one section with a law have it at all points", "[deck]") {
    const Problem same =
        read(replaced(with_law(layer), "section = \"s\"", "sections = [[0, \"s\"], [1, \"s\"]]"));
    CHECK_FALSE(same.model.rods[0].has_varying_sections());
    CHECK(same.model.sections[static_cast<std::size_t>(same.model.rods[0].section)].law != nullptr);
    const std::string twice =
        replaced(of_shape("circle = { radius = 1 }"), "material =", "law = { " + layer + " }\nmaterial =");
    CHECK_THAT(faults_of(twice), Contains("section.s.law: yield_stress of the material is given too"));
}

TEST_CASE("A section with a law has the stiffness of small strains after a long time", "[deck]") {
    const auto stiffness = [](const std::string& deck) { return read(deck).model.sections[0].stiffness; };
    CHECK(stiffness(with_law(layer)).diagonal() == Vec6(1e4, 2e4, 3e4, 500.0, 700.0, 800.0));
    CHECK(stiffness(with_law("viscoelastic = { prony = [[1, 1]] }")) == stiffness(rod_deck));
    CHECK(stiffness(with_law("plastic = { yield = { T = 1 } }")) == stiffness(rod_deck));
    CHECK(stiffness(with_curve("y = [[0, 0], [0.5, 10], [1, 11]]")).diagonal() ==
          Vec6(1e4, 2e4, 3e4, 500.0, 20.0, 700.0));
    CHECK(read(replaced(rod_deck, "inertia = { rhoA", "trapeze = false\ninertia = { rhoA"))
              .model.sections[0]
              .law == nullptr);
}

TEST_CASE("A material that yields gives its shape layers or fibres of the same stiffness", "[deck]") {
    for (const std::string shape : {"circle = { radius = 1 }",
                                    "tube = { outer_radius = 1, inner_radius = 0.9 }",
                                    "rectangle = { width_y = 1, height_z = 2 }"}) {
        INFO(shape);
        const Section yielding = read(of_shape(shape)).model.sections[0];
        const Section elastic = read(replaced(of_shape(shape), ", yield_stress = 0.3", "")).model.sections[0];
        REQUIRE(yielding.law != nullptr);
        CHECK(elastic.law == nullptr);
        CHECK(yielding.stiffness.isApprox(elastic.stiffness, 1e-13));
        const std::string together = replaced(of_shape(shape), "0.3 }", "0.3, interaction = true }");
        const Section fibres = read(together).model.sections[0];
        REQUIRE(dynamic_cast<const FibreLaw*>(fibres.law.get()) != nullptr);
        CHECK(fibres.stiffness.isApprox(elastic.stiffness, 1e-13));
        CHECK(dynamic_cast<const LayeredLaw*>(yielding.law.get()) != nullptr);
    }
}

TEST_CASE("A law takes the trapeze's term in addition", "[deck]") {
    const Problem problem =
        read(replaced(with_law(layer), "inertia = { rhoA", "trapeze = true\ninertia = { rhoA"));
    const auto* law = dynamic_cast<const TrapezeLaw*>(problem.model.sections[0].law.get());
    REQUIRE(law != nullptr);
    CHECK(law->coefficient() == 1300.0);
    CHECK(dynamic_cast<const LayeredLaw*>(&law->inner()) != nullptr);
}

}  // namespace gxrod::test
