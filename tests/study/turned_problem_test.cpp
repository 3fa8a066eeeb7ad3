#include <cmath>

#include "study/deck_study_text.hpp"
#include "tools/catch.hpp"
#include "verification/studied_decks.hpp"

using namespace gxrod;
using namespace gxrod::test;

namespace {

// Everything that turning a model must turn: loads of each frame, functions of time and place, supports with
// axes of their own that move, gravity that changes, bodies with offsets, velocities, every quantity of a
// history.
const std::string everything = R"deck(title = "Everything"
gravity = [0.3, "-9.81*cos(t)", 0.1]
[section.s]
stiffness = { EA = 1e4, GAy = 6e3, GAz = 5e3, GJ = 80, EIy = 100, EIz = 140 }
inertia = { rhoA = 1, rhoIy = 0.01, rhoIz = 0.02 }
damping = { kelvin_voigt = 1e-3, mass_proportional = 0.1 }
[rod.arm]
section = "s"
spline = [[0, 0, 0], [1, 0.5, 0.2], [2, 0, 0.7]]
elements = 4
order = 2
[rod.leg]
section = "s"
line = { from = [2, 0, 0.7], to = [3, 0, 0] }
elements = 2
[[connect]]
points = ["arm.end", "leg.start"]
[body.tool]
mass = 0.5
inertia = [0.1, 0.2, 0.25]
at = "leg.end"
centre_of_mass = [0.1, 0.05, -0.1]
rotation_vector = [0.2, -0.3, 0.4]
[body.lone]
mass = 1.5
inertia = [0.3, 0.2, 0.25]
at = [5, 5, 5]
velocity = [0.1, 0.2, -0.3]
angular_velocity = [1, 2, 3]
[[support]]
at = "arm.start"
fix = ["x", "y", "rx", "ry"]
move = { z = "0.05*sin(3*t)", rz = "0.4*t*t" }
axes = [[0.36, 0.48, -0.8], [-0.8, 0.6, 0], [0.48, 0.64, 0.6]]
[[load]]
at = "leg.end"
force = [1, "2*sin(5*t)", 0]
moment = [0, 0.2, "0.3*t"]
[[load]]
at = "arm.end"
force = [0, "3*t", 1]
moment = [0.1, 0, 0]
frame = "follower"
[[load]]
at = "arm@0.5"
force = [0, 2, "t"]
moment = [0.3, 0.1, 0]
frame = "body"
[[load]]
on = "arm"
force_per_length = ["0.5*s", 0, "-t"]
moment_per_length = [0, 0.1, 0]
[[load]]
on = "leg"
force_per_length = [0, 0.4, 0.2]
frame = "follower"
[[load]]
on = "leg"
force_per_length = [0.1, "s*t", 0.2]
frame = "body"
[analysis]
kind = "dynamic"
end_time = 0.5
steps = 25
[[history]]
name = "tip"
at = "leg.end"
quantities = ["position", "displacement", "rotation_vector", "orientation", "velocity", "angular_velocity",
  "angular_velocity_material", "acceleration", "force", "moment", "force_spatial", "moment_spatial", "strain", "curvature"]
[[history]]
name = "root"
at = "arm.start"
quantities = ["reaction_force", "reaction_moment"]
[[history]]
name = "body"
at = "lone"
quantities = ["position", "quaternion", "orientation", "rotation_vector", "centre_of_mass", "velocity"]
[[history]]
name = "seen"
at = "leg.end"
relative_to = "arm.end"
quantities = ["position", "displacement", "velocity", "acceleration", "rotation_vector", "quaternion", "orientation"]
)deck";

}  // namespace

TEST_CASE("a turned model has the turned motion", "[study]") {
    for (const char* integrator : {"newmark-simplified", "sdirk-4"}) {
        INFO(integrator);
        const DeckStudy turned =
            study(everything,
                  {VariantKind::turned},
                  {std::string("analysis.integrator=") + integrator, "analysis.newton.tolerance=1e-12"});
        REQUIRE(turned.runs.size() == 2);
        REQUIRE(turned.runs[1].is_whole());
        // Of a rotation's two forms one is followed.
        CHECK(turned.series.size() == 14 + 2 + 5 + 6);
        for (const SeriesReport& report : turned.series) {
            INFO(report.series.title());
            CHECK(report.scale > 0.0);
            CHECK(report.relative(report.turned_difference) < 1e-9);
        }
        CHECK(turned.is_sound());
        CHECK(turned.rotation.norm() > 0.5);
    }
}

TEST_CASE("statics turn as dynamics do", "[study]") {
    std::string text = everything;
    text.replace(
        text.find("kind = \"dynamic\"\nend_time = 0.5\nsteps = 25"), 42, "kind = \"static\"\nsteps = 4");
    // What moves freely has no place in statics.
    const std::size_t lone = text.find("[body.lone]");
    text.erase(lone, text.find("[[support]]") - lone);
    const std::size_t history = text.find("[[history]]\nname = \"body\"");
    text.erase(history, text.find("[[history]]\nname = \"seen\"") - history);
    const DeckStudy turned = study(text, {VariantKind::turned}, {"analysis.newton.tolerance=1e-12"});
    REQUIRE(turned.runs.size() == 2);
    INFO(turned.runs[0].failure);
    REQUIRE(turned.runs[1].is_whole());
    for (const SeriesReport& report : turned.series) {
        INFO(report.series.title());
        CHECK(report.relative(report.turned_difference) < 1e-9);
    }
}
