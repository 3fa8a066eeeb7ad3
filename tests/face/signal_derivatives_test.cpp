// Derivatives of controlled motions by gains, and by all else.
#include <complex>

#include "deck/decks.hpp"
#include "face/derivative_by_runs.hpp"

namespace gxrod::test {
namespace {

using Catch::Contains;

// A body on a slider, pushed by a sampled controller towards 1.
const std::string cart = R"deck([parameters]
kp = 8
ki = 3
kd = 4
m = 2
[body.cart]
mass = "m"
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
[signal.place]
measure = "cart.position.x"
[signal.push]
value = "1 - place"
pid = { proportional = "kp", integral = "ki", derivative = "kd" }
[[load]]
at = "cart"
force = ["push", 0, 0]
[analysis]
kind = "dynamic"
end_time = 2
time_step = 0.02
integrator = "newmark-simplified"
)deck";

struct Numbers {
    std::complex<double> kp = 8.0, ki = 3.0, kd = 4.0, m = 2.0;
};

// The place of that cart in the same steps, by hand.
std::complex<double> drive(const Numbers& by) {
    constexpr double step = 0.02;
    std::complex<double> x = 0.0, v = 0.0, a = 0.0, before = 1.0, integral = 0.0;
    for (int i = 0; i < 100; ++i) {
        const std::complex<double> error = 1.0 - x;
        if (i > 0) integral += step * error;
        const std::complex<double> rate = (error - before) / step;
        const std::complex<double> next = (by.kp * error + by.ki * integral + by.kd * rate) / by.m;
        before = error;
        x += step * v + 0.25 * step * step * (a + next);
        v += 0.5 * step * (a + next);
        a = next;
    }
    return x;
}

// A rod with a body at its end, which a filtered and bounded controller holds up.
const std::string arm = R"deck(gravity = [0, 0, -9.81]
[parameters]
kp = 8
ki = 40
kd = 0.2
T = 0.03
most = 2.5
EI = 6
L = 1
[section.s]
stiffness = { EA = 1e3, GAy = 1e3, GAz = 1e3, GJ = 5, EIy = "EI", EIz = 7 }
inertia = { rhoA = 1, rhoJ = 0.2, rhoIy = 0.1, rhoIz = 0.1 }
damping = { kelvin_voigt = 0.02 }
[rod.r]
section = "s"
line = { from = [0, 0, 0], to = ["L", 0, 0] }
elements = 3
[[support]]
at = "r.start"
fix = "all"
[[history]]
name = "tip"
at = "r.end"
quantities = ["position", "velocity"]
[signal.height]
measure = "tip.position.z"
filter = "T"
[signal.pull]
value = "0.1 - height"
pid = { proportional = "kp", integral = "ki", derivative = "kd" }
lower = 0
upper = "most"
HOLD
[[load]]
at = "r.end"
force = [0.3, 0, "pull"]
)deck";

const std::string moves =
    "[analysis]\nkind = \"dynamic\"\nend_time = 0.8\ntime_step = 0.02\nintegrator = \"SCHEME\"\n"
    "newton = { tolerance = 1e-11 }\n";
const std::string creeps =
    "[analysis]\nkind = \"quasi-static\"\nend_time = 0.8\ntime_step = 0.02\nnewton = { tolerance = 1e-11 }\n";
const std::string stages = R"deck([[stage]]
name = "sag"
kind = "static"
steps = 2
[[stage]]
name = "move"
kind = "dynamic"
end_time = 0.2
time_step = 0.01
integrator = "newmark-simplified"
newton = { tolerance = 1e-11 }
[[stage]]
name = "rest"
kind = "static"
steps = 2
)deck";

Deck arm_of(const std::string& analysis, const std::string& hold = "hold = \"linear\"") {
    return Deck::from_text(replaced(arm, "HOLD", hold) + analysis);
}

double value_of(const Deck& deck, const std::string& name) {
    const std::string& text = deck.text();
    return std::stod(text.substr(text.find("\n" + name + " = ") + name.size() + 4));
}

// Small, so that no signal reaches a bound in one run alone.
constexpr double part = 3e-5;

void check_by_runs(const Deck& deck, const std::vector<std::string>& numbers, double tolerance) {
    for (const std::string& number : numbers) {
        INFO(number);
        const double value = value_of(deck, number);
        require_close(carry_along(deck, number, "tip", "position"),
                      take_differences(deck, number, value, "tip", "position", part),
                      tolerance);
    }
}

// A cart with a spring and a damper, or a continuous controller that is both.
const std::string rail = R"deck([parameters]
k = 8
d = 4
[body.cart]
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
end_time = 1
time_step = 0.02
integrator = "SCHEME"
newton = { tolerance = 1e-12 }
)deck";

const std::string spring = "spring = { stiffness = \"k\", damping = \"d\", rest = 1 }\n";
const std::string controller = R"deck(drive = "push"
[signal.place]
measure = "rail.slide"
continuous = true
[signal.speed]
measure = "rail.slide_rate"
continuous = true
[signal.push]
value = "k*(1 - place) - d*speed"
continuous = true
start = "k"
)deck";

}  // namespace

TEST_CASE("derivatives by the gains of a sampled controller are those of its recurrence", "[face][signals]") {
    const Deck deck = Deck::from_text(cart);
    constexpr double tiny = 1e-30;
    const auto check = [&](const std::string& name, const Numbers& by) {
        INFO(name);
        const double expected = drive(by).imag() / tiny;
        CHECK(std::abs(carry_along(deck, name, "cart", "position")[0] - expected) <
              1e-8 * std::abs(expected));
    };
    const std::complex<double> i(0.0, tiny);
    CHECK(find_end(deck, "kp", 8.0, "cart", "position")[0] == Approx(drive({}).real()).epsilon(1e-10));
    check("kp", {.kp = 8.0 + i});
    check("ki", {.ki = 3.0 + i});
    check("kd", {.kd = 4.0 + i});
    check("m", {.m = 2.0 + i});
}

TEST_CASE("derivatives of a controlled rod are those of whole runs", "[face][signals]") {
    const std::string scheme = GENERATE("newmark-simplified", "generalized-alpha", "sdirk-4", "radau-5");
    INFO(scheme);
    check_by_runs(
        arm_of(replaced(moves, "SCHEME", scheme)), {"kp", "ki", "kd", "T", "most", "EI", "L"}, 1e-5);
}

TEST_CASE("derivatives of controlled creep and stages are those of whole runs", "[face][signals]") {
    check_by_runs(arm_of(creeps, ""), {"kp", "T", "EI"}, 1e-5);
    check_by_runs(arm_of(stages), {"kp", "ki", "EI", "L"}, 1e-5);
    check_by_runs(arm_of(stages, ""), {"kd"}, 1e-5);
}

TEST_CASE("a continuous controller has the derivatives of a spring and a damper", "[face][signals]") {
    const std::string scheme = GENERATE("newmark-simplified", "generalized-alpha");
    const auto find = [&](const std::string& control, const std::string& name, const std::string& what) {
        const Deck deck = Deck::from_text(replaced(replaced(rail, "CONTROL", control), "SCHEME", scheme));
        return carry_along(deck, name, "rail", what)[0];
    };
    for (const char* name : {"k", "d"}) {
        for (const char* what : {"slide", "slide_rate"}) {
            CAPTURE(scheme, name, what);
            if (scheme == "newmark-simplified")  // the other one asks for forces within steps
                CHECK(find(controller, name, what) == Approx(find(spring, name, what)).epsilon(1e-6));
            const Deck deck =
                Deck::from_text(replaced(replaced(rail, "CONTROL", controller), "SCHEME", scheme));
            require_close(carry_along(deck, name, "rail", what),
                          take_differences(deck, name, value_of(deck, name), "rail", what),
                          1e-5);
        }
    }
}

TEST_CASE("derivatives of a continuous controller of a rod are those of whole runs", "[face][signals]") {
    std::string continuous = replaced(arm, "filter = \"T\"", "continuous = true");
    continuous = replaced(continuous, "HOLD", "continuous = true\nstart = 0.8");
    // Bounds that are met in a step, and rates of a signal itself, let runs cut steps.
    continuous = replaced(replaced(continuous, "lower = 0\nupper = \"most\"\n", ""), "kd = 0.2", "kd = 0");
    const std::string analysis = GENERATE(as<std::string>{}, "newmark-simplified", "sdirk-4", "creeps");
    INFO(analysis);
    const Deck deck =
        Deck::from_text(continuous + (analysis == "creeps" ? creeps : replaced(moves, "SCHEME", analysis)));
    check_by_runs(deck, {"kp", "EI"}, 1e-6);
}

TEST_CASE("derivatives of controlled motions return to a checkpoint", "[face][signals]") {
    const Deck deck = arm_of(replaced(moves, "SCHEME", "newmark-simplified"));
    std::vector<VariedNumber> variations;
    variations.push_back(vary(deck, "kp"));
    Simulation run(deck.build(), {.sensitivities = std::move(variations)});
    run.advance(std::nullopt, 13);
    const Checkpoint saved = run.save();
    const auto derivative = [&] { return run["tip"].derivative("kp")["velocity"].numbers(); };
    const std::vector<double> then = derivative();
    run.run();
    const std::vector<double> end = derivative();
    run.restore(saved);
    CHECK(derivative() == then);
    run.run();
    CHECK(derivative() == end);
}

TEST_CASE("a signal at a kink has no derivative from there on", "[face][signals]") {
    const std::string folded = replaced(cart, "value = \"1 - place\"", "value = \"abs(place - shift)\"");
    const Deck deck = Deck::from_text(replaced(replaced(folded, "kp = 8", "kp = 8\nshift = 0.2"),
                                               "at = [0, 0, 0]\n[joint",
                                               "at = [0.2, 0, 0]\n[joint"));
    std::vector<VariedNumber> variations;
    variations.push_back(vary(deck, "shift"));
    variations.push_back(vary(deck, "m"));
    Simulation run(deck.build(), {.sensitivities = std::move(variations)});
    run.step();
    CHECK_THROWS_WITH(run["cart"].derivative("shift")["position"].numbers(),
                      Contains("does not exist from t = 0.02 on, where signal push has a kink or jumps"));
    CHECK(run["cart"].derivative("m")["position"].numbers().size() == 3);
}

TEST_CASE("signals have no derivatives by multipliers", "[face][signals]") {
    const Deck deck = Deck::from_text(cart);
    Simulation run(deck.build());
    run.run();
    std::vector<VariedNumber> variations;
    variations.push_back(vary(deck, "kp"));
    CHECK_THROWS_WITH(run.find_gradient({{0, 0, {1.0, 0.0, 0.0}}}, variations),
                      Contains("signals, which act by what they measure, cannot be gone back through"));
}

}  // namespace gxrod::test
