// Bodies, lines and grounds whose parts, attitudes and first equilibria once gave wrong answers.

#include <fmt/format.h>

#include <numbers>

#include "check/surroundings/surroundings_findings.hpp"
#include "deck/decks.hpp"
#include "deck/surroundings/surroundings_decks.hpp"
#include "tools/catch.hpp"
#include "tools/recorded_motion.hpp"

namespace gxrod::test {
namespace {

using Catch::Contains;
using tools::RecordedMotion;

constexpr double g = 9.81;

// Mass 6, volume 0.005, drag areas 0.035 and the coefficient 0.5, turned.
std::string ball(const std::string& around, const std::string& turn, const std::string& more = "") {
    return "gravity = [0, 0, -9.81]\n" + around +
           "[body.ball]\nmass = 6.0\ninertia = [0.02, 0.02, 0.02]\nat = [0, 0, 0]\nrotation_vector = " +
           turn +
           "\nfluid = { volume = 0.005, drag_area = [0.035, 0.035, 0.035], drag_coefficient = 0.5, "
           "added_mass = [2.5, 2.5, 2.5] }\n" +
           more +
           "[[history]]\nname = \"ball\"\nat = \"ball\"\nquantities = [\"velocity\"]\n"
           "[analysis]\nkind = \"dynamic\"\ntime_step = 0.01\n";
}

Vec3 velocity_at(const RecordedMotion& motion, double time) {
    const auto row = motion.at(time, "ball/velocity");
    return {row[0], row[1], row[2]};
}

// A chain of MoorDyn's tests, 410 m between an anchor 50 m deep and a vessel 400 m away, on a ground half a
// diameter lower. It hangs, then nothing moves.
std::string chain(const std::string& friction, const std::string& stages) {
    return R"(gravity = [0, 0, -9.80665]
[fluid]
density = 1025
surface = 0
[seabed]
z = -50.126
stiffness = 1e5
damping = 1e4
)" + friction +
           R"([section.chain]
stiffness = { EA = 1.674e9, GAy = 6.4e8, GAz = 6.4e8, GJ = 4e5, EIy = 5e5, EIz = 5e5 }
inertia = { rhoA = 390, rhoIy = 1.5, rhoIz = 1.5 }
fluid = { outer_diameter = 0.252, drag = { normal = 1.37, tangential = 0.64 } }
[rod.line]
section = "chain"
catenary = { from = [400, 0, -50], to = [0, 0, 0], length = 410, bed = true }
elements = 41
[[support]]
at = "line.start"
fix = ["position", "rx", "rz"]
[[support]]
at = "line.end"
fix = "position"
[[history]]
name = "anchor"
at = "line.start"
quantities = ["effective_tension"]
)" + stages;
}

const std::string hang_and_sway = R"([[stage]]
name = "hang"
kind = "static"
steps = 4
[[stage]]
name = "sway"
kind = "dynamic"
integrator = "generalized-alpha"
time_step = 0.05
end_time = 0.1
)";

// The end of a pipe of 0.3 m, clamped on a ground at z = −100.
std::string clamped_pipe(double z) {
    return fmt::format(R"(gravity = [0, 0, -9.81]
[fluid]
density = 1025
[seabed]
z = -100
stiffness = 3e5
[section.pipe]
stiffness = {{ EA = 5e8, GAy = 2e8, GAz = 2e8, GJ = 8e6, EIy = 1e7, EIz = 1e7 }}
inertia = {{ rhoA = 150, rhoIy = 1, rhoIz = 1 }}
fluid = {{ outer_diameter = 0.3 }}
[rod.r]
section = "pipe"
line = {{ from = [0, 0, {0}], to = [60, 0, {0}] }}
elements = 60
order = 2
[[support]]
at = "r.start"
fix = "all"
[[history]]
name = "anchor"
at = "r.start"
quantities = ["moment_spatial"]
[analysis]
kind = "static"
steps = 4
)",
                       z);
}

std::string findings_of(const std::string& deck) {
    const Problem problem = read(deck);
    std::string all;
    for (const Finding& finding : examine_surroundings(problem.model, problem.analysis()))
        all += finding.message + "\n";
    return all;
}

// A wire of 2 m along x on a floor, of which the last part rubs, pulled along itself.
std::string pulled_wire(const std::string& part, int elements, int order) {
    return fmt::format(R"(gravity = [0, 0, -9.81]
[section.s]
shape = {{ circle = {{ radius = 0.01 }} }}
material = {{ E = 1e9, nu = 0.3, density = 1000 }}
[rod.wire]
section = "s"
line = {{ from = [0, 0, 0.0101], to = [2, 0, 0.0101] }}
elements = {}
order = {}
[obstacle.floor]
plane = {{ point = [0, 0, 0], normal = [0, 0, 1] }}
[contact]
[[contact.pair]]
between = ["{}", "floor"]
friction = 0.5
[[support]]
at = "wire.start"
fix = ["y", "rx", "ry", "rz"]
move = {{ x = "-0.01*t" }}
[[history]]
name = "pull"
at = "wire.start"
quantities = ["reaction_force"]
[analysis]
kind = "static"
steps = 10
)",
                       elements,
                       order,
                       part);
}

// A cantilever of length 1 along x of which a part is driven.
std::string driven_cantilever(const std::string& drive, int elements, int order) {
    return fmt::format(R"([section.s]
stiffness = {{ EA = 1e6, GAy = 1e6, GAz = 1e6, GJ = 10, EIy = 10, EIz = 10 }}
expansion = 1e-5
[rod.r]
section = "s"
line = {{ from = [0, 0, 0], to = [1, 0, 0] }}
y_axis = [0, 1, 0]
elements = {}
order = {}
[[support]]
at = "r.start"
fix = "all"
[[actuation]]
on = "r"
{}
[[history]]
name = "tip"
at = "r.end"
quantities = ["displacement", "rotation_vector"]
[analysis]
kind = "static"
)",
                       elements,
                       order,
                       drive);
}

}  // namespace

TEST_CASE("A turned ball sinks straight down, as fast as one that is not turned", "[issues]") {
    // √(2 (m − ρV) g/(ρ C A)), FloatingArrayDesign/MoorDyn#268.
    const double expected = -std::sqrt(2.0 * (6.0 - 5.0) * g / (1000.0 * 0.5 * 0.035));
    CHECK(expected == Approx(-1.0588403).epsilon(1e-7));
    for (const char* turn : {"[0, 0, 0]", "[0.6155, 0.6155, 0]", "[0.3, -1.1, 2.0]"}) {
        const RecordedMotion motion(ball("[fluid]\ndensity = 1000\n", turn) + "end_time = 10\n");
        CHECK((velocity_at(motion, 10.0) - Vec3(0.0, 0.0, expected)).norm() < 1e-8);
    }
}

TEST_CASE("A turned ball falls straight down in air, and goes with an oblique current", "[issues]") {
    const double falls = std::sqrt(2.0 * 6.0 * g / (1.2 * 0.5 * 0.035));
    const RecordedMotion in_air(ball("[air]\ndensity = 1.2\n", "[0.6155, 0.6155, 0]") + "end_time = 60\n");
    CHECK((velocity_at(in_air, 60.0) - Vec3(0.0, 0.0, -falls)).norm() < 1e-5 * falls);
    // Without weight in water it takes the velocity of the current, in a straight line.
    const std::string current = "[fluid]\ndensity = 1000\ncurrent = { velocity = [0.6, -0.8, 1.0] }\n";
    const RecordedMotion carried(replaced(ball(current, "[0.6155, 0.6155, 0]"), "mass = 6.0", "mass = 5.0") +
                                 "end_time = 2\n");
    for (const double time : {0.1, 0.5, 2.0}) {
        const Vec3 velocity = velocity_at(carried, time);
        CHECK(velocity.cross(Vec3(0.6, -0.8, 1.0)).norm() < 1e-9);
    }
}

TEST_CASE("Friction of the ground begins where the first equilibrium ends", "[issues]") {
    const auto tension = [](const std::string& friction, const std::string& stages, double time) {
        return RecordedMotion(chain(friction, stages)).at(time, "anchor/effective_tension")[0];
    };
    const double smooth = tension("", hang_and_sway, 0.0);
    const double rough = tension("friction = 0.5\n", hang_and_sway, 0.0);
    CHECK(smooth > 8e5);
    CHECK(rough == Approx(smooth).epsilon(1e-9));
    // It begins with nothing to hold, so that the line stays where it is.
    CHECK(tension("friction = 0.5\n", hang_and_sway, 0.1) == Approx(smooth).epsilon(1e-6));
    // Where a deck says so it acts from the start.
    const double held = tension(
        "friction = { axial = 0.5, lateral = 0.5, stages = [\"hang\", \"sway\"] }\n", hang_and_sway, 0.0);
    CHECK(held < 0.9 * smooth);
}

TEST_CASE("Stages of friction are those that a deck names, or all but a first static one", "[issues]") {
    const auto coefficients = [](const std::string& friction, const std::string& stages) {
        const Problem problem = read(chain(friction, stages));
        std::vector<double> all{problem.model.surroundings.seabed->axial_friction};
        // Modes have the loads of the stage before them, and no own.
        for (std::size_t i = 1; i < problem.stages.size(); ++i) {
            const std::optional<Seabed>& seabed = problem.stages[i].actions.surroundings.seabed;
            if (seabed) all.push_back(seabed->axial_friction);
        }
        return all;
    };
    const std::string half = "friction = 0.5\n";
    CHECK(coefficients(half, hang_and_sway) == std::vector{0.0, 0.5});
    CHECK(coefficients(half, "[analysis]\nkind = \"static\"\n") == std::vector{0.5});
    const std::string modes = "[[stage]]\nname = \"m\"\nkind = \"modes\"\ncount = 1\n";
    CHECK(coefficients(half, "[[stage]]\nname = \"a\"\nkind = \"static\"\n" + modes) == std::vector{0.5});
    CHECK(coefficients(half, hang_and_sway.substr(hang_and_sway.find("[[stage]]\nname = \"sway\""))) ==
          std::vector{0.5});
    const std::string pull = "[[stage]]\nname = \"pull\"\nkind = \"static\"\n";
    CHECK(coefficients(half, hang_and_sway + pull) == std::vector{0.0, 0.5, 0.5});
    const std::string named = "friction = { axial = 0.5, lateral = 0.5, stages = \"pull\" }\n";
    CHECK(coefficients(named, hang_and_sway + pull) == std::vector{0.0, 0.0, 0.5});
    CHECK_THAT(faults_of(chain(replaced(named, "pull", "pul"), hang_and_sway + pull)),
               Contains("seabed.friction.stages") && Contains("pul"));
}

TEST_CASE("A line that is held at the height of the ground is a finding with the height to take",
          "[issues]") {
    const double weight = g * (150.0 - 1025.0 * std::numbers::pi / 4.0 * 0.09);
    const double at_rest = -100.0 + 0.15 - weight / (3e5 * 0.3);
    const std::string low = findings_of(clamped_pipe(-100.0));
    CHECK_THAT(low, Contains("r.start is held") && Contains(fmt::format("expected z = {:.6g}", at_rest)));
    CHECK(findings_of(clamped_pipe(at_rest)).empty());
    CHECK(findings_of(clamped_pipe(-99.85)).empty());
    CHECK(findings_of(clamped_pipe(-90.0)).empty());
    // What the finding is for: 134 kN m at the height of the ground.
    const auto moment = [](double z) {
        return std::abs(RecordedMotion(clamped_pipe(z)).at(1.0, "anchor/moment_spatial")[1]);
    };
    CHECK(moment(-100.0) > 1e5);
    CHECK(moment(at_rest) < 1.0);
}

TEST_CASE("Friction of a part of a rod is that of the part", "[issues]") {
    const double weight = g * 1000.0 * std::numbers::pi * 1e-4 * 2.0;
    const auto pull = [](const std::string& part, int elements, int order) {
        return -RecordedMotion(pulled_wire(part, elements, order)).at(1.0, "pull/reaction_force")[0];
    };
    // Friction acts on the surface, a radius below the line, which bends the free end up a little: with ever
    // finer meshes the pull there is 3.5 % less.
    for (const int order : {1, 2}) {
        CHECK(pull("wire@0.95..1", 10, order) == Approx(0.965 * 0.5 * 0.05 * weight).epsilon(0.01));
        CHECK(pull("wire@0.33..0.47", 10, order) == Approx(0.5 * 0.14 * weight).epsilon(2e-3));
        CHECK(pull("w*@0..1", 10, order) == Approx(0.5 * weight).epsilon(1e-6));
    }
}

TEST_CASE("An actuation of a part of a rod counts by the part's share of elements", "[issues]") {
    const auto tip = [](const std::string& drive, int order) {
        return RecordedMotion(driven_cantilever(drive, 10, order)).at(1.0, "tip/displacement")[0];
    };
    for (const int order : {1, 2, 3}) {
        CHECK(tip("stretch = \"s < 0.345 ? 0.01 : 0\"", order) == Approx(0.00345).epsilon(1e-9));
        CHECK(tip("temperature = \"s > 0.17 && s < 0.345 ? 100 : 0\"", order) ==
              Approx(1e-3 * 0.175).epsilon(1e-9));
        CHECK(tip("stretch = \"s < 0.345*t ? 0.01 : 0\"", order) == Approx(0.00345).epsilon(1e-9));
    }
    const RecordedMotion bent(driven_cantilever("curvature = [0, 0, \"s < 0.345 ? 0.1 : 0\"]", 10, 1));
    CHECK(bent.at(1.0, "tip/rotation_vector")[2] == Approx(0.0345).epsilon(1e-9));
}

}  // namespace gxrod::test
