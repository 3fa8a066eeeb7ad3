// Signals: what a run measures acts in its next step.

#include <cmath>

#include "tools/problem_run.hpp"
#include "tools/recorded_motion.hpp"

using namespace gxrod;
using namespace gxrod::tools;
using test::replaced;

namespace {

using Catch::Contains;
using Motion = RecordedMotion;

// A body on a slider, pushed by a controller towards 1.
const std::string cart = R"deck([body.cart]
mass = 2
inertia = [1, 1, 1]
at = [0, 0, 0]
[joint.rail]
type = "slider"
between = ["ground", "cart"]
axis = [1, 0, 0]
[[history]]
name = "cart"
at = "cart"
quantities = ["position", "velocity"]
[signal.error]
value = "1 - place"
[signal.place]
measure = "cart.position.x"
[signal.push]
value = "error"
pid = PID
BOUNDS
[[load]]
at = "cart"
force = ["push", 0, 0]
[analysis]
kind = "dynamic"
end_time = END
time_step = STEP
integrator = "newmark-simplified"
)deck";

std::string cart_with(const std::string& pid,
                      const std::string& end,
                      const std::string& step,
                      const std::string& bounds = "") {
    return replaced(
        replaced(replaced(replaced(cart, "PID", pid), "BOUNDS", bounds), "END", end), "STEP", step);
}

}  // namespace

// m ẍ + d ẋ + p x = p, from rest.
TEST_CASE("A controller of position and rate moves a cart as a spring and a damper would",
          "[analyses][signals]") {
    const double m = 2.0, p = 8.0, d = 4.0, end = 3.0;
    const double decay = 0.5 * d / m, omega = std::sqrt(p / m - decay * decay);
    const double exact =
        1.0 - std::exp(-decay * end) * (std::cos(omega * end) + decay / omega * std::sin(omega * end));
    const auto error = [&](const char* step) {
        const Motion motion(cart_with("{ proportional = 8, derivative = 4 }", "3", step));
        return std::abs(motion.at(end, "cart/position")[0] - exact);
    };
    const double coarse = error("0.02"), fine = error("0.005");
    CHECK(coarse < 0.02);
    CHECK(coarse / fine == Approx(4.0).epsilon(0.2));  // the delay of a step: of the first order
}

// The error y has m y‴ + d ÿ + p ẏ + i y = 0, with the poles −1 and −1 ± i for 2 (1, 3, 4, 2), and y = 1, ẏ =
// 0, ÿ = −p/m at the start.
TEST_CASE("A controller with an integral has the poles of its transfer function", "[analyses][signals]") {
    const std::string pid = "{ proportional = 8, integral = 4, derivative = 6 }";
    const Motion fine(cart_with(pid, "4", "0.001"));
    const Motion twice(cart_with(pid, "4", "0.002"));
    const auto exact = [](double t) {
        const double e = std::exp(-t);
        const double a = -2.0, b = 3.0, c = 1.0;
        return 1.0 - e * (a + b * std::cos(t) + c * std::sin(t));
    };
    for (const double t : {1.0, 2.0, 4.0}) {
        const double error = fine.at(t, "cart/position")[0] - exact(t);
        CHECK(std::abs(error) < 5e-3);
        CHECK(std::abs(twice.at(t, "cart/position")[0] - exact(t)) ==
              Approx(2.0 * std::abs(error)).epsilon(0.2));
    }
}

TEST_CASE("A bounded controller does not wind up", "[analyses][signals]") {
    const std::string pid = "{ proportional = 4, integral = 4, derivative = 5 }";
    const Motion bounded(cart_with(pid, "24", "0.01", "lower = -0.5\nupper = 0.5"));
    double most = 0.0;
    for (const double push : bounded.all("/inputs/push")) most = std::max(most, std::abs(push));
    CHECK(most == 0.5);
    double farthest = 0.0;
    const auto positions = bounded.all("/histories/cart/position");
    for (std::size_t i = 0; i < positions.size(); i += 3) farthest = std::max(farthest, positions[i]);
    CHECK(farthest < 1.4);
    CHECK(bounded.at(24.0, "cart/position")[0] == Approx(1.0).margin(0.02));
}

TEST_CASE("Signals are resumed to the last bit", "[analyses][signals][resume]") {
    const std::string deck =
        replaced(cart_with("{ proportional = 8, integral = 3, derivative = 4 }", "1", "0.01"),
                 "measure = \"cart.position.x\"",
                 "measure = \"cart.position.x\"\nfilter = 0.05");
    const Motion whole(deck), resumed(deck, {}, 37);
    for (const char* name : {"/histories/cart/position", "/inputs/push", "/inputs/place"})
        CHECK(resumed.all(name) == whole.all(name));
}

// A first-order filter of a ramp t lags by T (1 − e^{−t/T}); of steps that are short against T.
TEST_CASE("A filter lags and a rate is that of the last step", "[analyses][signals]") {
    const std::string signals = R"deck([signal.ramp]
value = "3*t"
filter = 0.2
[signal.slope]
value = "ramp"
rate = true
)deck";
    const Motion motion(replaced(
        cart_with("{ proportional = 0 }", "1", "0.001"), "[signal.error]", signals + "[signal.error]"));
    // What acts at the end of a step was set at its start.
    const double t = 0.999;
    CHECK(motion.all("/inputs/ramp").back() ==
          Approx(3.0 * (t - 0.2 * (1.0 - std::exp(-t / 0.2)))).epsilon(2e-3));
    CHECK(motion.all("/inputs/slope").back() == Approx(3.0 * (1.0 - std::exp(-t / 0.2))).epsilon(5e-3));
}

TEST_CASE("Gains that are too high for the steps are warned of", "[analyses][signals]") {
    const sample::ScratchFolder folder;
    const auto warnings = [&](const std::string& step) {
        const std::string deck = cart_with("{ proportional = 2, derivative = 300 }", "0.6", step);
        const RunSummary summary = run_problem(test::read(deck), folder / ("run" + step + ".vtkhdf"));
        std::string all;
        for (const std::string& warning : summary.warnings) all += warning + "\n";
        return all;
    };
    CHECK_THAT(warnings("0.02"), Contains("signal push goes to and fro from step to step"));
    CHECK(warnings("0.001").find("to and fro") == std::string::npos);
}

namespace {

// A cart that a signal of its place and speed pushes within each step.
const std::string steered = R"deck([body.cart]
mass = 2
inertia = [1, 1, 1]
at = [0, 0, 0]
[joint.rail]
type = "slider"
between = ["ground", "cart"]
axis = [1, 0, 0]
CONTROL
[[history]]
name = "rail"
at = "rail"
quantities = ["slide", "slide_rate"]
[analysis]
kind = "dynamic"
end_time = 2
time_step = STEP
integrator = "SCHEME"
)deck";

const std::string signals_of_steering = R"deck(drive = "push"
[signal.place]
measure = "rail.slide"
continuous = true
[signal.speed]
measure = "rail.slide_rate"
continuous = true
[signal.push]
value = "8*(1 - place) - 4*speed"
continuous = true
start = 8
)deck";

std::string steer(const std::string& control, const std::string& scheme, const std::string& step) {
    return replaced(replaced(replaced(steered, "CONTROL", control), "SCHEME", scheme), "STEP", step);
}

}  // namespace

// A spring and a damper say the same at the ends of steps, where this scheme asks for forces.
TEST_CASE("A continuous controller is a spring and a damper, step by step", "[analyses][signals]") {
    const std::string spring = "spring = { stiffness = 8, damping = 4, rest = 1 }\n";
    const Motion signal(steer(signals_of_steering, "newmark-simplified", "0.02"));
    const Motion same(steer(spring, "newmark-simplified", "0.02"));
    for (const double t : {0.02, 0.5, 2.0}) {
        CHECK(signal.at(t, "rail/slide")[0] == Approx(same.at(t, "rail/slide")[0]).epsilon(1e-8));
        CHECK(signal.at(t, "rail/slide_rate")[0] ==
              Approx(same.at(t, "rail/slide_rate")[0]).epsilon(1e-7).margin(1e-8));
    }
}

TEST_CASE("Continuous controllers are of the second order in the step", "[analyses][signals]") {
    const double decay = 1.0, omega = std::sqrt(3.0);
    const double exact =
        1.0 - std::exp(-decay * 2.0) * (std::cos(omega * 2.0) + decay / omega * std::sin(omega * 2.0));
    for (const char* scheme : {"newmark-simplified", "generalized-alpha", "sdirk-4", "radau-5"}) {
        INFO(scheme);
        const auto error = [&](const char* step) {
            return std::abs(Motion(steer(signals_of_steering, scheme, step)).at(2.0, "rail/slide")[0] -
                            exact);
        };
        const double coarse = error("0.04"), fine = error("0.02");
        CHECK(coarse < 2e-3);
        CHECK(coarse / fine == Approx(4.0).epsilon(0.15));
    }
}

TEST_CASE("A run with continuous signals resumes to the last bit", "[analyses][signals]") {
    const std::string deck = steer(signals_of_steering, "newmark-simplified", "0.02");
    const Motion whole(deck), resumed(deck, {}, 33);
    CHECK(resumed.all("/histories/rail/slide") == whole.all("/histories/rail/slide"));
}
