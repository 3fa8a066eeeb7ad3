// Joints that break at a time.

#include <cmath>

#include "tools/problem_run.hpp"
#include "tools/recorded_motion.hpp"

using namespace gxrod;
using namespace gxrod::tools;
using test::replaced;

namespace {

using Motion = RecordedMotion;

// A mass on a line that swings, and is let go at T, which is no multiple of the step.
const std::string let_go = R"deck(gravity = [0, 0, -9.81]
[body.mass]
mass = 2
inertia = [0.3, 0.3, 0.3]
at = [0.6, 0, 0.2]
[joint.line]
type = "distance"
between = ["ground", "mass"]
at_a = [0, 0, 1]
at_b = [0.6, 0, 0.2]
breaks = { time = 0.6137 }
[analysis]
kind = "dynamic"
end_time = 1
time_step = STEP
integrator = "SCHEME"
[[history]]
name = "mass"
at = "mass"
quantities = ["position", "velocity"]
[[history]]
name = "line"
at = "line"
quantities = ["holds", "force"]
)deck";

std::string let_go_with(const std::string& scheme, const std::string& step) {
    return replaced(replaced(let_go, "SCHEME", scheme), "STEP", step);
}

// A bar on a prop at its end, which a stage before has loaded.
const std::string on_prop = R"deck([section.s]
stiffness = { EA = 1e6, GAy = 1e6, GAz = 1e6, GJ = 100, EIy = 100, EIz = 100 }
inertia = { rhoA = 1, rhoIy = 1e-3, rhoIz = 1e-3 }
[rod.r]
section = "s"
line = { from = [0, 0, 0], to = [1, 0, 0] }
elements = 4
order = 3
[[support]]
at = "r.start"
fix = "all"
[joint.prop]
type = "generic"
between = ["ground", "r.end"]
axis = [0, 0, 1]
holds = "x"
breaks = { BREAKS }
[[load]]
at = "r.end"
force = [0, 0, 4]
[[stage]]
name = "load"
kind = "static"
steps = 4
[[stage]]
name = "wait"
kind = "quasi-static"
end_time = 1
time_step = 0.1
[[stage]]
name = "go"
kind = "quasi-static"
end_time = 1
time_step = 0.1
[[history]]
name = "tip"
at = "r.end"
quantities = ["displacement"]
[[history]]
name = "prop"
at = "prop"
quantities = ["force", "holds"]
)deck";

}  // namespace

TEST_CASE("A mass that is let go at a time flies freely from there", "[analyses][joints]") {
    for (const char* scheme : {"newmark-simplified",
                               "newmark-ibrahimbegovic",
                               "generalized-alpha",
                               "sdirk-4",
                               "radau-5",
                               "runge-kutta-4"}) {
        INFO(scheme);
        const Motion motion(let_go_with(scheme, "0.02"));
        CHECK(motion.at(0.6, "line/holds")[0] == 1.0);
        CHECK(motion.at(0.6137, "line/holds")[0] == 0.0);
        const auto from = motion.at(0.6137, "mass/position"), rate = motion.at(0.6137, "mass/velocity");
        const double flown = 1.0 - 0.6137;
        const auto there = motion.at(1.0, "mass/position"), fast = motion.at(1.0, "mass/velocity");
        CHECK(there[0] == Approx(from[0] + flown * rate[0]).margin(1e-12));
        CHECK(there[2] == Approx(from[2] + flown * rate[2] - 0.5 * 9.81 * flown * flown).margin(1e-12));
        CHECK(fast[0] == Approx(rate[0]).margin(1e-12));
        CHECK(fast[2] == Approx(rate[2] - 9.81 * flown).margin(1e-12));
        CHECK(motion.at(1.0, "line/force")[0] == 0.0);
    }
}

TEST_CASE("A break at a time keeps the order of the scheme", "[analyses][joints]") {
    for (const char* scheme : {"newmark-simplified", "generalized-alpha"}) {
        INFO(scheme);
        const auto place = [&](const char* step) {
            return Motion(let_go_with(scheme, step)).at(1.0, "mass/position")[0];
        };
        const double first = place("0.04"), second = place("0.02"), third = place("0.01");
        CHECK(std::abs(first - second) > 3.0 * std::abs(second - third));
        CHECK(std::abs(second - third) < 1e-3);
    }
}

TEST_CASE("A run is resumed before, at and after a break at a time to the same bits", "[analyses][joints]") {
    for (const char* scheme : {"newmark-simplified", "generalized-alpha", "radau-5"}) {
        const std::string deck = let_go_with(scheme, "0.02");
        const Motion whole(deck);
        for (const int after : {30, 31, 32}) {
            INFO(scheme << " " << after);
            const Motion resumed(deck, {}, after);
            CHECK(resumed.all("/histories/time") == whole.all("/histories/time"));
            CHECK(resumed.all("/histories/mass/position") == whole.all("/histories/mass/position"));
            CHECK(resumed.all("/histories/mass/velocity") == whole.all("/histories/mass/velocity"));
            CHECK(resumed.all("/histories/line/force") == whole.all("/histories/line/force"));
        }
    }
}

TEST_CASE("Steps that are chosen by their error end where a joint breaks, too", "[analyses][joints]") {
    const Motion motion(replaced(let_go_with("sdirk-4", "0.02"),
                                 "integrator = \"sdirk-4\"",
                                 "integrator = \"sdirk-4\"\nadaptive = { tolerance = 1e-7 }"));
    CHECK(motion.at(0.6137, "line/holds")[0] == 0.0);
    const auto rate = motion.at(0.6137, "mass/velocity");
    CHECK(motion.at(1.0, "mass/velocity")[2] == Approx(rate[2] - 9.81 * (1.0 - 0.6137)).margin(1e-9));
}

TEST_CASE("A joint breaks at a time of a stage, and the model settles there", "[analyses][joints]") {
    const Motion motion(replaced(on_prop, "BREAKS", "time = 0.25, stage = \"go\""));
    CHECK(motion.at(0.0, "prop/force")[2] == Approx(-4.0).epsilon(1e-6));
    CHECK(motion.at(1.0, "prop/holds")[0] == 1.0);
    CHECK(motion.at(1.2, "prop/holds")[0] == 1.0);
    CHECK(motion.at(1.25, "prop/holds")[0] == 0.0);
    const Motion free(replaced(on_prop, "breaks = { BREAKS }", "stages = \"load\""));
    CHECK(motion.at(1.3, "tip/displacement")[2] == Approx(free.at(1.0, "tip/displacement")[2]).epsilon(1e-9));
    CHECK(std::abs(motion.at(1.3, "tip/displacement")[2]) > 1e-3);
    const std::string deck = replaced(on_prop, "BREAKS", "time = 0.25, stage = \"go\"");
    for (const int after : {16, 17, 18}) {
        const Motion resumed(deck, {}, after);
        CHECK(resumed.all("/histories/tip/displacement") == motion.all("/histories/tip/displacement"));
    }
    // A limit holds in all stages, the time in its own.
    const Motion both(replaced(on_prop, "BREAKS", "force = 3.5, time = 0.25, stage = \"go\""));
    CHECK(both.at(0.0, "prop/holds")[0] == 0.0);
}
