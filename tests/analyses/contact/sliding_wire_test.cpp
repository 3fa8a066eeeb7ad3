// A wire that is pushed round a bend, against the walls of which it slides.
#include "analyses/static.hpp"
#include "deck/decks.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

// A quarter of a circle of 50 mm, with a bore of 3 mm, between straight lines.
const char* const wire_in_bend = R"(
[section.wire]
shape    = { circle = { radius = 0.4e-3 } }
material = { E = 60e9, nu = 0.33 }
[rod.wire]
section  = "wire"
line     = { from = [-0.155, 0, 0], to = [-0.005, 0, 0] }
elements = 50
order    = 2
[obstacle.vessel]
tube     = { spline = [[-0.16, 0, 0], [-0.08, 0, 0], [-0.02, 0, 0], [-0.01, 0, 0], [0, 0, 0], [0.006526, 0.000428, 0], [0.012941, 0.001704, 0], [0.019134, 0.003806, 0], [0.025, 0.006699, 0], [0.030438, 0.010332, 0], [0.035355, 0.014645, 0], [0.039668, 0.019562, 0], [0.043301, 0.025, 0]], radius = 1.5e-3, side = "inside" }
friction = 0.1
[[support]]
at   = "wire.start"
fix  = ["y", "z", "rotation"]
move = { x = "0.09*t" }
[analysis]
kind  = "static"
steps = 90
)";

}  // namespace

TEST_CASE("A wire slides round a bend in statics, without cut steps, in few iterations",
          "[analyses][touch]") {
    const Problem problem = read(wire_in_bend);
    const auto analysis = make_analysis(problem.model, problem.analysis(), 1);
    REQUIRE(analysis->start().converged());
    constexpr int steps = 30;
    int iterations = 0;
    double least_gap = 1.0;
    for (int step = 0; step < steps; ++step) {
        REQUIRE(analysis->advance().converged());
        CHECK(analysis->solver_row().rejected_steps == 0);
        iterations += analysis->solver_row().newton_iterations;
        least_gap = std::min(least_gap, analysis->solver_row().least_gap);
    }
    CHECK(iterations <= 15 * steps);
    CHECK(least_gap > 0.0);
    // All of the wall slides along, and rubs as Coulomb's friction does.
    const Snapshot last = analysis->snapshot(true);
    double pressed = 0.0, rubbed = 0.0;
    for (const ContactTouch& touch : last.touches) {
        CHECK(touch.slides);
        pressed += touch.normal_force.norm();
        rubbed += touch.friction_force.norm();
    }
    CHECK(pressed > 0.0);
    CHECK(rubbed == Approx(0.1 * pressed).epsilon(1e-9));
}

}  // namespace gxrod::test
