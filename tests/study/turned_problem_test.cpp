#include <cmath>
#include <set>

#include "study/deck_study_text.hpp"
#include "tools/catch.hpp"
#include "verification/studied_decks.hpp"
#include "watch/quantities.hpp"

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
  "angular_velocity_material", "acceleration", "force", "moment", "force_spatial", "moment_spatial", "strain", "curvature",
  "shear_force", "bending_moment", "axis_x", "no_load_angle"]
no_load = [1, 0.2, 0]
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
quantities = ["position", "displacement", "velocity", "acceleration", "rotation_vector", "quaternion", "orientation", "no_load_angle"]
no_load = [0, 0.3, 1]
)deck";

// Springs, bushings, joints, gears and tendons, with every quantity that they have.
const std::string ties = R"deck(title = "Ties"
gravity = [0.3, -9.81, 0.1]
[section.s]
stiffness = { EA = 1e4, GAy = 6e3, GAz = 5e3, GJ = 80, EIy = 100, EIz = 140 }
inertia = { rhoA = 1, rhoIy = 0.01, rhoIz = 0.02 }
[rod.arm]
section = "s"
line = { from = [0, 0, 0], to = [2, 0, 0] }
elements = 4
[tendon.cable]
on = "arm"
offset = [0, 0.05]
tension = "20*t"
friction = 0.2
[chamber.bellows]
on = "arm"
offset = [0.05, 0]
area = 0.01
pressure = "30*t"
[[support]]
at = "arm.start"
fix = "all"
[body.wheel]
mass = 2
inertia = [0.2, 0.1, 0.1]
at = [0, 2, 0]
centre_of_mass = [0.1, 0.05, 0]
angular_velocity = [3, 0, 0]
[body.shaft]
mass = 1
inertia = [0.1, 0.2, 0.2]
at = [0, 3, 0]
angular_velocity = [9, 0, 0]
[body.cart]
mass = 1.5
inertia = [0.3, 0.2, 0.25]
at = [3, 3, 1]
velocity = [0, 0.192, 0.256]
[body.bead]
mass = 0.3
inertia = [0.01, 0.01, 0.01]
at = [1, 0, 0]
velocity = [0.2, 0, 0]
[joint.driven]
type = "hinge"
between = ["ground", "shaft"]
axis = [1, 0, 0]
drive = "2*t"
[joint.pin]
type = "hinge"
between = ["ground", "wheel"]
axis = [1, 0, 0]
[joint.guide]
type = "cylinder"
between = ["ground", "cart"]
axis = [0, 0.6, 0.8]
friction = { slide = { force = 0.3 } }
[joint.sleeve]
type = "sleeve"
between = ["arm", "bead"]
[body.bob]
mass = 0.2
inertia = [0.01, 0.01, 0.01]
at = [3, 3, 2]
velocity = [0.1, 0.5, 0.3]
angular_velocity = [1, 2, 0]
[joint.loose]
type = "ball"
between = ["cart", "bob"]
at = [3, 3, 2]
clearance = { gap = 0.005, stiffness = 1e3, exponent = 1.5, damping = 2, friction = 0.2, radius = 0.1, slip_speed = 0.1 }
[body.runner]
mass = 0.4
inertia = [0.01, 0.01, 0.01]
at = [-2, 0.7, 0]
velocity = [1, 0, 0.2]
[joint.groove]
type = "cam"
between = ["ground", "runner"]
at_a = [-2, 0, 0]
axis = [0, 0, 1]
x_axis = [0, 1, 0]
curve = { radius = "0.5 + 0.1*cos(2*angle)" }
roller = 0.1
[gear.reduction]
joints = ["pin", "driven"]
ratio = -3
[spring.strut]
between = ["arm.end", "cart"]
stiffness = 20
damping = 1
length = 2
[bushing.mount]
between = ["ground", "arm.end"]
axes = "b"
stiffness = { x = 100, y = 200, z = 300, rx = 10, ry = 20, rz = 30 }
damping = { x = 1, y = 2, rz = 1 }
[analysis]
kind = "dynamic"
end_time = 0.1
steps = 20
newton = { tolerance = 1e-12 }
[[history]]
name = "strut"
at = "strut"
quantities = ["elongation", "axial_force"]
[[history]]
name = "mount"
at = "mount"
quantities = ["displacement", "rotation_vector", "force", "moment", "force_spatial", "moment_spatial"]
[[history]]
name = "pin"
at = "pin"
quantities = ["angle", "angle_rate", "force", "moment", "force_a", "moment_a", "gap", "holds"]
[[history]]
name = "driven"
at = "driven"
quantities = ["drive"]
[[history]]
name = "guide"
at = "guide"
quantities = ["angle", "slide", "slide_rate", "force", "friction", "drive"]
[[history]]
name = "sleeve"
at = "sleeve"
quantities = ["slide", "slide_rate", "force", "force_a"]
[[history]]
name = "gear"
at = "reduction"
quantities = ["drive", "play", "gap"]
[[history]]
name = "loose"
at = "loose"
quantities = ["play", "force", "moment"]
[[history]]
name = "groove"
at = "groove"
quantities = ["normal_force", "curve_place", "curve_gap", "force"]
[[history]]
name = "cable"
at = "cable"
quantities = ["tendon_length", "tendon_tension", "tendon_end_tension"]
[[history]]
name = "bellows"
at = "bellows"
quantities = ["volume", "pressure"]
[[history]]
name = "clamp"
at = "arm.start"
about = [1, 2, 3]
quantities = ["reaction_force", "reaction_moment"]
)deck";

// Water, ground and contact, which know up from down, with every quantity of theirs.
const std::string surroundings = R"deck(title = "Around"
gravity = [0, 0, -9.81]
[section.s]
shape = { tube = { outer_radius = 0.05, inner_radius = 0.04 } }
material = { E = 2e9, nu = 0.3, density = 1500 }
fluid = { contents = { density = 900 } }
[rod.riser]
section = "s"
line = { from = [0, 0, -4.855], to = [4, 1, -5.455] }
elements = 4
[[support]]
at = "riser.end"
move = { z = "0.1*t" }
[material.steel]
E = 2e9
nu = 0.3
density = 1500
yield_stress = 1e6
[layup.sheet]
plies = [["steel", 0.01, 0]]
[section.box]
shape = { walls = { corners = [[-0.05, -0.03], [0.05, -0.03], [0.05, 0.03], [-0.05, 0.03]], closed = true, layup = "sheet" } }
[rod.boom]
section = "box"
line = { from = [0, 9, 5], to = [1, 9.5, 5.2] }
elements = 2
[[support]]
at = "boom.start"
fix = "all"
[body.float]
mass = 20
inertia = [1, 1, 1]
at = [0, 5, -0.1]
fluid = { volume = 0.03, drag_area = [0.1, 0.1, 0.1] }
[body.ball]
mass = 0.5
inertia = [5e-4, 5e-4, 5e-4]
at = [0, 0, 1.0503]
velocity = [2, 0.5, 0]
angular_velocity = [0, 1, 2]
sphere = { radius = 0.05 }
[rod.wire]
section = "s"
line = { from = [2, 0, 1.0503], to = [2.5, 0.3, 1.0503] }
elements = 2
[[initial]]
on = "wire"
velocity = [0.3, 0.4, 0]
[obstacle.floor]
plane = { point = [0, 0, 1], normal = [0, 0, 1] }
friction = 0.3
[contact]
rods = ["wire"]
self = false
skin = 1e-3
[fluid]
density = 1000
surface = 0
depth = 4.9
current = { table = [[-10, 1], [0, 3]], direction = [3, 4, 0] }
[[wave]]
airy = { height = 1, period = 4 }
direction = [1, 2, 0]
[air]
density = 1.2
wind = { velocity = [3, 1, 0] }
[seabed]
stiffness = 1e4
plane = { point = [0, 0, -4.9], normal = [0.1, 0.2, 1] }
[analysis]
kind = "dynamic"
end_time = 0.04
steps = 20
newton = { tolerance = 1e-12 }
[[history]]
name = "riser"
at = "riser@0.4"
quantities = ["effective_tension", "wall_tension", "water_velocity", "wet_fraction", "fluid_force", "bed_force"]
[[history]]
name = "lying"
at = "riser"
quantities = ["touch_down_start", "touch_down_end", "touch_down_start_position", "touch_down_end_position"]
[[history]]
name = "boom"
at = "boom.start"
point = [0.05, 0.03]
quantities = ["stress", "von_mises", "principal_stress", "exposure", "stress_place"]
[[history]]
name = "float"
at = "float"
quantities = ["wet_fraction", "fluid_force"]
[[history]]
name = "floor"
at = "floor"
quantities = ["contact_force", "contact_friction", "least_gap"]
[[history]]
name = "wire"
at = "wire"
quantities = ["contact_force", "contact_friction", "least_gap"]
[[history]]
name = "ball"
at = "ball"
with = "floor"
quantities = ["position", "angular_velocity_material", "contact_force", "contact_friction", "least_gap"]
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
        CHECK(turned.series.size() == 18 + 2 + 6 + 6);
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

TEST_CASE("every quantity turns with the model as its line says", "[study]") {
    std::set<const Quantity*> seen;
    for (const std::string& deck : {everything, ties, surroundings}) {
        const DeckStudy turned = study(deck, {VariantKind::turned}, {"analysis.newton.tolerance=1e-12"});
        INFO(turned.title);
        REQUIRE(turned.runs.size() == 2);
        REQUIRE(turned.runs[1].is_whole());
        CHECK(turned.rotation.norm() > 0.5);
        for (const SeriesReport& report : turned.series) {
            INFO(report.series.title());
            CHECK(report.relative(report.turned_difference) < 1e-7);
            seen.insert(report.series.quantity);
        }
    }
    for (const QuantityTable* table : list_quantity_tables()) {
        for (const Quantity& line : table->lines) {
            INFO(table->owners << " " << line.word << ": " << line.meaning);
            CHECK((line.continuous != nullptr || seen.contains(&line)));
        }
    }
}
