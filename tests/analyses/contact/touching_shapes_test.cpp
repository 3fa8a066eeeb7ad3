// Modes, eigenvalues, response and buckling of what touches: contacts are springs.
#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>
#include <variant>

#include "deck/decks.hpp"
#include "tools/catch.hpp"
#include "tools/problem_run.hpp"

#include "analyses/contact/contact_run.hpp"

using namespace gxrod;
using namespace gxrod::tools;
using test::ContactRun;
using test::read;

namespace {

// Two balls on springs along x, pressed together by a force on each.
std::string pressed_balls(double force, const std::string& friction = "0") {
    return fmt::format(R"(
[body.left]
mass = 2
inertia = [1, 1, 1]
at = [0, 0, 0]
sphere = {{ radius = 0.5, force = 10 }}
[body.right]
mass = 2
inertia = [1, 1, 1]
at = [1.005, 0, 0]
sphere = {{ radius = 0.5, force = 10 }}
[[support]]
at = "left"
fix = ["y", "z", "rotation"]
[[support]]
at = "right"
fix = ["y", "z", "rotation"]
[spring.one]
between = ["left", "ground"]
at_b = [-1, 0, 0]
stiffness = 50
[spring.other]
between = ["right", "ground"]
at_b = [2.005, 0, 0]
stiffness = 50
[[load]]
at = "left"
force = [{}, 0, 0]
[[load]]
at = "right"
force = [{}, 0, 0]
[contact]
friction = {}
)",
                       force,
                       -force,
                       friction);
}

const std::string press =
    "[[stage]]\nname = \"press\"\nkind = \"static\"\nsteps = 3\nnewton = { tolerance = 1e-12 }\n";

std::string shapes(const std::string& kind, int count) {
    return fmt::format("[[stage]]\nname = \"shapes\"\nkind = \"{}\"\ncount = {}\n", kind, count);
}

// The distance of both, and the force between them.
struct Press {
    double distance = 0.0, force = 0.0;
};
Press find_press(double force) {
    ContactRun run(pressed_balls(force) +
                   "[analysis]\nkind = \"static\"\nsteps = 3\nnewton = { tolerance = 1e-13 }\n");
    run.finish();
    const double left = run.at("left").r.x(), right = run.at("right").r.x();
    return {right - left, force - 50.0 * left};
}

RunSummary run_complete(const std::string& deck) {
    RunSummary summary = run_problem(read(deck));
    INFO(summary.reason);
    REQUIRE(summary.status == RunStatus::complete);
    return summary;
}

template <class Record>
const Record& record_of(const RunSummary& summary) {
    return std::get<Record>(summary.shapes.back().record);
}

}  // namespace

TEST_CASE("Shapes: two balls that are pressed together are two masses with a spring between them",
          "[analyses][touch]") {
    const Press less = find_press(9.999), more = find_press(10.001);
    const double spring = -(more.force - less.force) / (more.distance - less.distance);
    CHECK(spring > 1e3);
    const std::string deck = pressed_balls(10.0) + press;
    const auto modes = record_of<ModesRecord>(run_complete(deck + shapes("modes", 2))).modes;
    REQUIRE(modes.size() == 2);
    CHECK(modes[0].omega_squared == Approx(25.0).epsilon(1e-9));
    CHECK(modes[1].omega_squared == Approx((50.0 + 2.0 * spring) / 2.0).epsilon(1e-5));
    const RunSummary eigenvalues = run_complete(deck + shapes("eigenvalues", 2));
    const auto& found = record_of<EigenvaluesRecord>(eigenvalues).modes;
    REQUIRE(found.size() == 2);
    CHECK(found[0].omega == Approx(modes[0].omega).epsilon(1e-9));
    CHECK(found[1].omega == Approx(modes[1].omega).epsilon(1e-9));
}

TEST_CASE("Shapes: two balls without a gap that is within the skin vibrate each by itself",
          "[analyses][touch]") {
    const RunSummary summary = run_complete(pressed_balls(-5.0) + press + shapes("modes", 2));
    for (const Mode& mode : record_of<ModesRecord>(summary).modes)
        CHECK(mode.omega_squared == Approx(25.0).epsilon(1e-9));
}

TEST_CASE("Shapes: a response at frequency 0 is the static one", "[analyses][touch]") {
    const RunSummary summary =
        run_complete(pressed_balls(10.0) + press +
                     "[[stage]]\nname = \"push\"\nkind = \"response\"\nomega = { values = [0] }\n"
                     "excite = [{ at = \"left\", force = [1, 0, 0] }]\n"
                     "[[history]]\nname = \"tip\"\nat = \"left\"\nquantities = [\"displacement\"]\n");
    const Vec6 moved = record_of<ResponseRecord>(summary).responses.at(0).motion.real[0];
    // Of one force on two masses with a spring, each on another one.
    const Press less = find_press(9.999), more = find_press(10.001);
    const double spring = -(more.force - less.force) / (more.distance - less.distance);
    CHECK(moved[0] == Approx((50.0 + spring) / (50.0 * (50.0 + 2.0 * spring))).epsilon(1e-6));
}

// The state is at rest, but the step that ends there was one of a motion, whose contact acts by impulses.
TEST_CASE("Shapes: contact is the same spring after a motion as after statics", "[analyses][touch]") {
    const std::string deck = R"(
gravity = [0, 0, -10]
[body.ball]
mass = 0.5
inertia = [5e-4, 5e-4, 5e-4]
at = [0, 0, 0.2505]
sphere = { radius = 0.05, force = 10 }
[spring.side]
between = ["ball", "ground"]
at_b = [1, 0, 0.2505]
stiffness = 300
[[support]]
at = "ball"
fix = ["y", "rotation"]
[obstacle.hill]
sphere = { centre = [0, 0, 0], radius = 0.2 }
[contact]
dissipation = 0.5
)" + press;
    const std::string wait = "[[stage]]\nname = \"wait\"\nkind = \"dynamic\"\nend_time = 1e-6\nsteps = 1\n";
    const auto at_rest = record_of<ModesRecord>(run_complete(deck + shapes("modes", 2)));
    const auto after = record_of<ModesRecord>(run_complete(deck + wait + shapes("modes", 2)));
    REQUIRE(at_rest.modes.size() == 2);
    for (std::size_t i = 0; i < 2; ++i)
        CHECK(after.modes.at(i).omega_squared == Approx(at_rest.modes[i].omega_squared).epsilon(1e-6));
    // 600 − λ/(R + r) of the ball on the hill, over its mass.
    CHECK(at_rest.modes[0].omega_squared == Approx((300.0 - 5.0 / 0.25) / 0.5).epsilon(2e-3));
}

// A column between two jaws, half way up: the jaws hold it, and it buckles in two half waves.
TEST_CASE("Shapes: jaws that touch a column hold it against buckling", "[analyses][touch]") {
    const auto column = [](double gap) {
        std::string deck = R"(
[section.s]
stiffness = { EA = 1e5, GAy = 1e6, GAz = 1e6, GJ = 10, EIy = 10, EIz = 40 }
radius = 0.02
[rod.column]
section = "s"
line = { from = [0, 0, 0], to = [0, 0, 1] }
elements = 8
order = 4
[[support]]
at = "column.start"
fix = ["position", "rx", "rz"]
[[support]]
at = "column.end"
fix = ["x", "y", "rx", "rz"]
[[load]]
at = "column.end"
force = [0, 0, -1]
[contact]
skin = 0.1
)";
        for (const int side : {1, -1}) {
            const double x = side * (0.04 + gap);
            const char* name = side > 0 ? "right" : "left";
            deck += fmt::format(
                "[body.{0}]\nat = [{1}, 0, 0.5]\ncapsule = {{ from = [0, -0.1, 0], to = [0, 0.1, 0], radius "
                "= 0.02 }}\n[[support]]\nat = \"{0}\"\nfix = \"all\"\n",
                name,
                x);
        }
        return deck + press + shapes("buckling", 2);
    };
    const double euler = std::pow(std::numbers::pi, 2) * 10.0;
    const RunSummary open = run_complete(column(2.1e-3)), held = run_complete(column(1.9e-3));
    const auto& free_factors = record_of<BucklingRecord>(open).factors;
    const auto& held_factors = record_of<BucklingRecord>(held).factors;
    REQUIRE(free_factors.size() == 2);
    REQUIRE(held_factors.size() == 2);
    CHECK(1.0 + free_factors[0].factor == Approx(euler).epsilon(2e-3));
    CHECK(1.0 + held_factors[0].factor == Approx(4.0 * euler).epsilon(2e-2));
}

// Two bars that cross and stick to each other, against a bar that slides: κ/ĝ against nothing.
TEST_CASE("Shapes: friction holds in small motions, and slides with continued loading", "[analyses][touch]") {
    const auto drawn = [](double along, const char* linearization) {
        return fmt::format(R"(
[body.left]
mass = 2
inertia = [1, 1, 1]
at = [0, 0, 0]
sphere = {{ radius = 0.5, force = 10 }}
[body.right]
at = [1.005, 0, 0]
sphere = {{ radius = 0.5, force = 10 }}
[[support]]
at = "left"
fix = ["z", "rotation"]
[[support]]
at = "right"
fix = "all"
[spring.one]
between = ["left", "ground"]
at_b = [0, 1, 0]
stiffness = 50
[[load]]
at = "left"
force = [10, {}, 0]
[contact]
friction = 0.3
{}[[stage]]
name = "shapes"
kind = "modes"
count = 1
linearization = "{}"
)",
                           along,
                           press,
                           linearization);
    };
    const auto lowest = [&](double along, const char* linearization) {
        return record_of<ModesRecord>(run_complete(drawn(along, linearization))).modes.at(0).omega_squared;
    };
    CHECK(lowest(1.0, "elastic") > 1e3);
    CHECK(lowest(1.0, "loading") > 1e3);
    CHECK(lowest(4.0, "elastic") > 1e3);
    CHECK(lowest(4.0, "loading") < 30.0);
}
