#include <algorithm>

#include "deck/decks.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

using Catch::Contains;

const std::string controlled = R"deck([body.cart]
mass = 2
inertia = [1, 1, 1]
at = [0, 0, 0]
[[history]]
name = "cart"
at = "cart"
quantities = ["position", "velocity"]
[signal.error]
value = "1 - place"
[signal.place]
measure = "cart.position.x"
filter = 0.5
[signal.push]
value = "error"
pid = { proportional = 2, integral = 3, derivative = 4 }
lower = -5
upper = 6
hold = "linear"
start = 7
[signal.speed]
value = "place"
rate = true
[[load]]
at = "cart"
force = ["push", 0, 0]
[analysis]
kind = "dynamic"
end_time = 1
time_step = 0.1
)deck";

const SignalPlan& find(const Problem& problem, const std::string& name) {
    const auto found = std::ranges::find(problem.signals, name, &SignalPlan::name);
    REQUIRE(found != problem.signals.end());
    return *found;
}

}  // namespace

TEST_CASE("Every key of a signal is seen in the problem", "[deck][signals]") {
    const Problem problem = read(controlled);
    REQUIRE(problem.signals.size() == 4);
    const SignalPlan& place = find(problem, "place");
    REQUIRE(place.measure.has_value());
    CHECK(place.measure->quantity == "position");
    CHECK(place.measure->column == 0);
    CHECK(place.filter == 0.5);
    CHECK_FALSE(place.is_rate);
    const SignalPlan& push = find(problem, "push");
    REQUIRE(push.pid.has_value());
    CHECK(push.pid->proportional == 2.0);
    CHECK(push.pid->integral == 3.0);
    CHECK(push.pid->derivative == 4.0);
    CHECK(push.lower == -5.0);
    CHECK(push.upper == 6.0);
    CHECK(push.input->hold() == InputHold::linear);
    CHECK((*push.input)(0.0) == 7.0);
    CHECK(find(problem, "speed").is_rate);
    // Each is set after those that it reads.
    CHECK(place.input->signal_rank() < find(problem, "error").input->signal_rank());
    CHECK(find(problem, "error").input->signal_rank() < push.input->signal_rank());
    CHECK(problem.model.loads.at(0).force[0](0.0) == 7.0);
}

TEST_CASE("What is wrong with a signal is reported with its place", "[deck][signals]") {
    CHECK(faults_of(controlled).empty());
    CHECK_THAT(faults_of(replaced(controlled, "cart.position.x", "car.position.x")),
               Contains("signal.place.measure: no history \"car\"; did you mean \"cart\"?"));
    CHECK_THAT(faults_of(replaced(controlled, "cart.position.x", "cart.rotation_vector.x")),
               Contains("history cart has no quantity \"rotation_vector\"; it has position, velocity"));
    CHECK_THAT(faults_of(replaced(controlled, "cart.position.x", "cart.position")),
               Contains("expected a component, such as \"cart.position.x\", y or z"));
    CHECK_THAT(faults_of(replaced(controlled, "1 - place", "1 - push")),
               Contains("signals read each other in a circle"));
    CHECK_THAT(faults_of(replaced(controlled, "[signal.error]", "[input.error]\n[signal.error]")),
               Contains("signal.error: an input has this name too"));
    CHECK_THAT(faults_of(replaced(controlled, "lower = -5", "lower = 8")),
               Contains("signal.push.lower: expected less than upper, 6"));
    CHECK_THAT(faults_of(replaced(controlled, "value = \"error\"", "value = \"error\"\nrate = true")),
               Contains("a controller has `derivative`"));
    CHECK_THAT(faults_of(replaced(controlled, "hold = \"linear\"", "hold = \"linear\"\ncontinuous = true")),
               Contains("signal.push.hold: a continuous signal goes on a straight line"));
}

}  // namespace gxrod::test
