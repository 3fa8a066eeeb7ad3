#include "check/summaries/model_summary.hpp"

#include "deck/decks.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {

TEST_CASE("A summary says what each signal is", "[check][signals]") {
    const Problem problem = read(body_deck + R"deck([[history]]
name = "spin"
at = "top"
quantities = ["angular_velocity"]
[signal.speed]
measure = "spin.angular_velocity.z"
filter = 0.1
[signal.growth]
value = "speed - 2"
rate = true
[signal.push]
value = "3 - speed"
pid = { proportional = 4, derivative = 5 }
lower = -6
upper = 7
)deck");
    CHECK(describe_signals(problem.signals, problem.output) ==
          "signal speed: spin angular_velocity, filtered by 0.1; acts one step later\n"
          "signal growth: rate of a function of t; acts one step later\n"
          "signal push: controller (proportional 4, integral 0, derivative 5) of a function of t, at least "
          "-6, at most "
          "7; acts one step later\n");
    SignalPlan pull;
    pull.name = "pull";
    pull.is_continuous = true;
    CHECK(describe_signals({pull}, {}) ==
          "signal pull: a function of t; acts in the step that it measures\n");
}

}  // namespace gxrod::test
