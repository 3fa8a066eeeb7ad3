#include "run/stepped_run.hpp"
#include "sensitivity/sensitivities.hpp"
#include "sensitivity/swing.hpp"
#include "tools/catch.hpp"

// Derivatives of what yields or slips under a load that is held were 0.8 to 1100 % off: the state is at a
// limit there, and differences of models next to it take one side that flows and one that does not.

namespace gxrod::test {
namespace {

using Catch::Contains;

// A bar that yields in bending about both axes.
const std::string yielding_bar = R"deck(gravity = [0, 0, "-1.0*(t < 0.25 ? sin(2*pi*t)^2 : 1)"]
[section.bar]
stiffness = { EA = 1e3, GAy = 500, GAz = 500, GJ = 1, EIy = 1, EIz = 1.5 }
inertia = { rhoA = 1, rhoJ = 0.02, rhoIy = 0.01, rhoIz = 0.01 }
law = { plastic = { yield = { My = 0.5, Mz = 0.5 }, kinematic = 0.5 } }
[rod.beam]
section = "bar"
line = { from = [0, 0, 0], to = [1, 0, 0] }
elements = 6
order = 2
y_axis = [0, 1, 0]
[[support]]
at = "beam.start"
fix = "all"
[parameters]
P = 1
[function.ramp]
expression = "t < 0.25 ? sin(2*pi*t)^2 : 1"
[[load]]
at = "beam.end"
force = [0, "0.2*ramp(t)", "-0.4*ramp(t)"]
[[load]]
at = "beam.end"
force = [0, "0.05*P*ramp(t)", 0]
[analysis]
kind = "quasi-static"
end_time = 0.4
steps = 20
newton = { tolerance = 1e-12, max_iterations = 60 }
)deck";

// A slider that a spring and a force push against its friction.
const std::string rubbing_slider = R"deck([parameters]
P = 1
mu = 0.3
[body.b]
mass = 1
inertia = [1, 1, 1]
[spring.s]
between = ["b", "ground"]
at_b = [-1, 0, 0]
stiffness = 2
[joint.guide]
type = "slider"
between = ["b", "ground"]
axis = [1, 0, 0]
friction = { force = "mu", stick = 1e-3 }
[[load]]
at = "b"
force = ["P*(t < 0.25 ? 4*t : 1)", 0, 0]
[analysis]
kind = "quasi-static"
end_time = 0.4
steps = 16
newton = { tolerance = 1e-12 }
)deck";

Vec3 place_of_last(const State& state) { return state.previous.back().r; }

Vec3 run_with(const std::string& deck, const std::string& name, double value) {
    const Problem problem = read(set(deck, name, value));
    SteppedRun simulation(request_of(problem));
    while (simulation.step()) {
    }
    REQUIRE(simulation.summary().reason.empty());
    return place_of_last(simulation.analysis().state());
}

Vec3 difference_of_runs(const std::string& deck, const std::string& name) {
    const double p = value_of(deck, name), h = 1e-4 * p;
    return (run_with(deck, name, p + h) - run_with(deck, name, p - h)) / (2.0 * h);
}

Vec3 carry_along(const std::string& deck, const std::string& name) {
    const Problem base = read(deck);
    const Variation varied(deck, name);
    SteppedRun simulation(request_of(base));
    REQUIRE(simulation.start());
    Sensitivities sensitivities(simulation.analysis(), base.analysis(), {varied.models()});
    sensitivities.start();
    while (!simulation.has_ended()) {
        sensitivities.note_before();
        REQUIRE(simulation.step());
        sensitivities.advance();
    }
    return sensitivities.by(0).direction().nodes.back().r;
}

}  // namespace

TEST_CASE("derivatives of what yields do not drift while the load is held", "[issues]") {
    const Vec3 right(-0.00209533, 0.01566234, -0.00162897);
    CHECK((carry_along(yielding_bar, "P") - right).norm() < 2e-8);
    const std::string layers =
        "layers = [{ on = \"bending\", stiffness = 2, limit = 0.1 }, "
        "{ on = \"bending\", stiffness = 1, limit = 0.3 }]";
    const std::string slipping =
        replaced(yielding_bar, "plastic = { yield = { My = 0.5, Mz = 0.5 }, kinematic = 0.5 }", layers);
    const Vec3 expected = difference_of_runs(slipping, "P");
    CHECK((carry_along(slipping, "P") - expected).norm() < 1e-6 * expected.norm());
}

TEST_CASE("derivatives of what rubs do not drift while the load is held", "[issues]") {
    for (const char* name : {"P", "mu"}) {
        INFO(name);
        const Vec3 expected = difference_of_runs(rubbing_slider, name);
        CHECK(expected.norm() > 0.1);
        CHECK((carry_along(rubbing_slider, name) - expected).norm() < 1e-7);
    }
}

TEST_CASE("derivatives of what slips at once are right, or refused where it does so in parts", "[issues]") {
    std::string deck = replaced(yielding_bar,
                                "plastic = { yield = { My = 0.5, Mz = 0.5 }, kinematic = 0.5 }",
                                "layers = [{ on = \"bending\", stiffness = 0.5, limit = 0.13 }]");
    for (const char* ramp : {"-1.0*(t < 0.25 ? sin(2*pi*t)^2 : 1)", "t < 0.25 ? sin(2*pi*t)^2 : 1"})
        deck = replaced(deck, ramp, ramp[0] == '-' ? "-1.0" : "1");
    const Vec3 expected = difference_of_runs(deck, "P");
    CHECK((carry_along(deck, "P") - expected).norm() < 1e-6 * expected.norm());
    const std::string in_parts = replaced(deck, "max_iterations = 60", "max_iterations = 4");
    CHECK_THROWS_WITH(carry_along(in_parts, "P"),
                      Contains("acts at once at t = 0") && Contains("it was brought on in"));
    // Actuation that is there at once.
    const std::string curved =
        deck + "\n[[actuation]]\non = \"beam\"\ncurvature = [\"0.2*P\", \"-0.347*P\", \"0.3*P*s\"]\n";
    const Vec3 of_curved = difference_of_runs(curved, "P");
    CHECK((carry_along(curved, "P") - of_curved).norm() < 1e-6 * of_curved.norm());
}

}  // namespace gxrod::test
