#include <cmath>

#include "deck/decks.hpp"
#include "run/stepped_run.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

using Catch::Contains;

// A cantilever of 2 along x that is pulled a little.
const std::string beam = R"deck([section.s]
shape = { rectangle = { width_y = 0.2, height_z = 0.1 } }
material = { E = 1e6, nu = 0.25, density = 3 }
[rod.r]
section = "s"
line = { from = [0, 0, 0], to = [2, 0, 0] }
elements = 2
order = 2
[[support]]
at = "r.start"
fix = "all"
[[load]]
at = "r.end"
force = [1e-5, 0, 0]
[analysis]
kind = "static"
newton = { tolerance = 1e-13 }
)deck";

std::string with(const std::string& line) { return replaced(beam, "[rod.r]", line + "\n[rod.r]"); }

Section section_of(const std::string& deck) { return read(deck).model.sections.at(0); }

NodeMotion tip_of(const std::string& deck) {
    const Problem problem = read(deck);
    RunRequest request{problem};
    SteppedRun simulation(request);
    while (simulation.step()) {
    }
    REQUIRE(simulation.summary().reason.empty());
    return simulation.take_snapshot().nodes[static_cast<std::size_t>(problem.model.rods[0].nodes.back())];
}

}  // namespace

TEST_CASE("a rectangle that is turned bends about its own axes", "[deck][sections]") {
    const Mat6 straight = section_of(beam).stiffness;
    const Section turned = section_of(with("turn = 0.3"));
    const double c = std::cos(0.3);
    const double s = std::sin(0.3);
    const double a = straight(4, 4);
    const double b = straight(5, 5);
    CHECK(turned.stiffness(0, 0) == Approx(straight(0, 0)).epsilon(1e-14));
    CHECK(turned.stiffness(3, 3) == Approx(straight(3, 3)).epsilon(1e-14));
    CHECK(turned.stiffness(4, 4) == Approx(c * c * a + s * s * b).epsilon(1e-13));
    CHECK(turned.stiffness(5, 5) == Approx(s * s * a + c * c * b).epsilon(1e-13));
    CHECK(turned.stiffness(4, 5) == Approx(c * s * (a - b)).epsilon(1e-12));
    CHECK(turned.mass(4, 5) == Approx(3.0 / 1e6 * c * s * (a - b)).epsilon(1e-12));
    CHECK(turned.stiffness(0, 4) == 0.0);
    // A quarter turn swaps its sides.
    const Mat6 upright = section_of(with("turn = \"pi/2\"")).stiffness;
    const Mat6 swapped =
        section_of(replaced(beam, "width_y = 0.2, height_z = 0.1", "width_y = 0.1, height_z = 0.2"))
            .stiffness;
    CHECK(upright.isApprox(swapped, 1e-13));
}

TEST_CASE("a beam on its corner is that of the offset formulas", "[deck][sections]") {
    const Section middle = section_of(beam);
    // The middle of the section is at (y, z) from the rod, which is its lower right corner.
    const Section corner = section_of(with("at = [0.1, 0.05]"));
    const double EA = middle.stiffness(0, 0);
    const double EIy = middle.stiffness(4, 4);
    const double EIz = middle.stiffness(5, 5);
    CHECK(corner.stiffness(4, 4) == Approx(EIy + EA * 0.05 * 0.05).epsilon(1e-13));
    CHECK(corner.stiffness(5, 5) == Approx(EIz + EA * 0.1 * 0.1).epsilon(1e-13));
    CHECK(corner.stiffness(4, 5) == Approx(-EA * 0.1 * 0.05).epsilon(1e-13));
    CHECK(corner.mass(0, 5) == Approx(-0.1 * corner.mass(0, 0)).epsilon(1e-13));
    CHECK(corner.mass(0, 4) == Approx(0.05 * corner.mass(0, 0)).epsilon(1e-13));
    // A force F along x at the corner has the moments −z F and y F about the middle.
    const NodeMotion tip = tip_of(with("at = [0.1, 0.05]"));
    const double F = 1e-5;  // so small that it does not stiffen the beam
    const double curvature_y = -0.05 * F / EIy;
    const double curvature_z = 0.1 * F / EIz;
    CHECK(tip.r.x() - 2.0 == Approx(2.0 * F * (1.0 / EA + 0.01 / EIz + 0.0025 / EIy)).epsilon(1e-5));
    CHECK(tip.r.y() == Approx(2.0 * curvature_z).epsilon(1e-5));
    CHECK(tip.r.z() == Approx(-2.0 * curvature_y).epsilon(1e-5));
}

TEST_CASE("turn can follow the arc length", "[deck][sections]") {
    const Model model = read(with("turn = \"pi/4*s\"")).model;
    const Mat6 straight = section_of(beam).stiffness;
    const auto& nodes = model.rods[0].varying.at_nodes;
    CHECK(nodes.front().stiffness.isApprox(straight, 1e-14));
    CHECK(nodes.back().stiffness(4, 4) == Approx(straight(5, 5)).epsilon(1e-13));
}

TEST_CASE("a point of a section has y and z", "[deck][sections]") {
    CHECK_THROWS_WITH(read(with("at = [0.1, 0.05, 0]")),
                      Contains("section.s.at: expected an array of 2 numbers or expressions, y and z"));
    CHECK_THROWS_WITH(read(with("at = 0.1")), Contains("section.s.at: expected an array of 2"));
}

}  // namespace gxrod::test
