#include <cmath>

#include "cross_section/heat/heat_strains.hpp"
#include "deck/decks.hpp"
#include "run/stepped_run.hpp"
#include "tools/catch.hpp"

// Heat in rods whose sections expand by their materials.
namespace gxrod::test {
namespace {

using Catch::Contains;

// A strip of two metals of equal thickness, aluminium above steel, in mm and N.
const std::string bimetal_deck = R"deck([material.steel]
E = 210e3
nu = 0.3
expansion = 12e-6
[material.aluminium]
E = 70e3
nu = 0.3
expansion = 23e-6
[layup.bimetal]
plies = [["steel", 0.5, 0], ["aluminium", 0.5, 0]]
[section.s]
shape = { walls = { corners = [[-2, 0], [2, 0]], layup = "bimetal" } }
[rod.r]
section = "s"
line = { from = [0, 0, 0], to = [100, 0, 0] }
y_axis = [0, 1, 0]
elements = 8
order = 3
[[support]]
at = "r.start"
fix = "all"
[[actuation]]
on = "r"
temperature = 200
[analysis]
kind = "static"
)deck";

constexpr double heat = 200.0, length = 100.0;
// Timoshenko's, of equal thicknesses.
constexpr double ratio = 3.0;
constexpr double curvature = 24.0 * 11e-6 * heat / (1.0 * (14.0 + ratio + 1.0 / ratio));

Vec3 find_tip(const std::string& deck) {
    const Problem problem = read(deck);
    RunRequest request{problem};
    SteppedRun simulation(request);
    while (simulation.step()) {
    }
    REQUIRE(simulation.summary().reason.empty());
    return simulation.take_snapshot().nodes[static_cast<std::size_t>(problem.model.rods[0].nodes.back())].r;
}

// The end of an arc that bends towards −z.
Vec3 arc_end(double stretch, double bend) {
    return (1.0 + stretch) / bend * Vec3(std::sin(bend * length), 0.0, std::cos(bend * length) - 1.0);
}

}  // namespace

TEST_CASE("A strip of two metals bends as Timoshenko has it", "[deck]") {
    // The stretch of the middle, from both materials' resultants.
    const double of_middle =
        (210.0 * 12e-6 + 70.0 * 23e-6) / 280.0 * heat + 0.25 * (210.0 - 70.0) / 280.0 * curvature;
    CHECK((find_tip(bimetal_deck) - arc_end(of_middle, curvature)).norm() < 1e-7 * length);
}

TEST_CASE("A section about another point is bent by heat as the same section", "[deck]") {
    const std::string moved =
        replaced(bimetal_deck, "layup = \"bimetal\" } }", "layup = \"bimetal\" } }\nat = [0, 0.25]");
    const double of_middle =
        (210.0 * 12e-6 + 70.0 * 23e-6) / 280.0 * heat + 0.25 * (210.0 - 70.0) / 280.0 * curvature;
    // The rod is a quarter below the middle, where the strip is shorter.
    CHECK((find_tip(moved) - arc_end(of_middle - 0.25 * curvature, curvature)).norm() < 1e-7 * length);
}

TEST_CASE("A section of one material is longer by heat, and bent by its gradient", "[deck]") {
    const std::string even = replaced(bimetal_deck, "expansion = 23e-6", "expansion = 12e-6");
    CHECK(read(even).model.sections[0].expansion == 12e-6);
    CHECK((find_tip(even) - Vec3((1.0 + 12e-6 * heat) * length, 0.0, 0.0)).norm() < 1e-9 * length);
    const std::string box =
        "shape = { box = { height = 4, width = 2, wall = 0.4 } }\n"
        "material = { E = 70e3, nu = 0.3, expansion = 12e-6 }";
    const std::string gradient = replaced(
        replaced(
            bimetal_deck, "shape = { walls = { corners = [[-2, 0], [2, 0]], layup = \"bimetal\" } }", box),
        "temperature = 200",
        "temperature = 200\ntemperature_gradient = [0, 50]");
    CHECK((find_tip(gradient) - arc_end(12e-6 * heat, 12e-6 * 50.0)).norm() < 1e-7 * length);
}

TEST_CASE("A gradient of temperature bends two metals by more than their difference", "[deck]") {
    // Two strips with the moduli E and free strains α g z: resultants about the middle, by hand.
    const double g = 40.0, E1 = 210e3, E2 = 70e3, t = 0.5;
    const auto moment = [t](double lower, double upper, int power) {
        return (std::pow(0.0, power + 1) - std::pow(-t, power + 1)) / (power + 1) * lower +
               (std::pow(t, power + 1) - std::pow(0.0, power + 1)) / (power + 1) * upper;
    };
    Eigen::Matrix2d C;
    C << moment(E1, E2, 0), moment(E1, E2, 1), moment(E1, E2, 1), moment(E1, E2, 2);
    const Eigen::Vector2d free(moment(E1 * 12e-6, E2 * 23e-6, 1) * g, moment(E1 * 12e-6, E2 * 23e-6, 2) * g);
    const Eigen::Vector2d strain = C.inverse() * free;
    const std::string deck = replaced(bimetal_deck, "temperature = 200", "temperature_gradient = [0, 40]");
    CHECK((find_tip(deck) - arc_end(strain[0], strain[1])).norm() < 1e-7 * length);
}

TEST_CASE("Heat that cannot be computed is refused", "[deck]") {
    CHECK_THAT(
        faults_of(replaced(replaced(bimetal_deck, "expansion = 23e-6\n", ""), "expansion = 12e-6\n", "")),
        Contains(
            "actuation[0].temperature: the section of the rod r has no expansion, so that heat does nothing; "
            "expected a key expansion of its [section.NAME] or of its materials"));
}

TEST_CASE("Two strips of metals, upside down, bend by heat as their mean in between", "[deck]") {
    const std::string other =
        "[layup.turned]\nplies = [[\"aluminium\", 0.5, 0], [\"steel\", 0.5, 0]]\n[section.t]\n"
        "shape = { walls = { corners = [[-2, 0], [2, 0]], layup = \"turned\" } }\n[rod.r]";
    const std::string deck = replaced(
        replaced(bimetal_deck, "[rod.r]", other), "section = \"s\"", "sections = [[0, \"s\"], [1, \"t\"]]");
    const Problem problem = read(deck);
    const Actuation& heat = problem.model.actuations.at(1);
    // At the first force point of eight elements of order 3, almost as at the start.
    const double s = 100.0 / 8.0 * 0.5 * (1.0 - std::sqrt(0.6));
    CHECK(heat.strain[4](1.0, s) == Approx(curvature * (1.0 - 2.0 * s / length)));
    CHECK(heat.strain[4](1.0, length - s) == Approx(-curvature * (1.0 - 2.0 * s / length)));
    const std::string plain = replaced(
        replaced(deck,
                 "[rod.r]",
                 "[section.u]\nstiffness = { EA = 1, GAy = 1, GAz = 1, GJ = 1, EIy = 1, EIz = 1 }\n[rod.r]"),
        "[1, \"t\"]]",
        "[1, \"u\"]]");
    CHECK_THAT(faults_of(plain),
               Contains("actuation[0].temperature: heat bends a section of this deck, and the rod r"));
    CHECK(std::abs(find_tip(deck).z() + curvature * length * length / 6.0) < 5e-2);
}

}  // namespace gxrod::test
