// Beads on rods whose motion is known.

#include <array>
#include <cmath>
#include <complex>

#include "tools/recorded_motion.hpp"

using namespace gxrod;
using namespace gxrod::tools;
using Catch::Contains;
using test::replaced;

namespace {

using Motion = RecordedMotion;

const std::vector<std::string> schemes{
    "newmark-simplified", "newmark-ibrahimbegovic", "generalized-alpha", "sdirk-4", "runge-kutta-4"};

std::vector<std::string> with(const std::string& scheme, const std::string& step) {
    std::vector<std::string> overrides{"analysis.integrator=\"" + scheme + "\"",
                                       "analysis.time_step=" + step};
    if (scheme != "runge-kutta-4") overrides.push_back("analysis.newton.tolerance=1e-12");
    return overrides;
}

// A rod whose nodes are moved turns at 2 rad/s; a bead flies out, s = 0.1 cosh 2t.
const std::string turning_rod = R"deck(
[section.s]
stiffness = { EA = 1e3, GAy = 1e3, GAz = 1e3, GJ = 1e3, EIy = 1e3, EIz = 1e3 }
inertia = { rhoA = 1, rhoIy = 1, rhoIz = 1 }
[rod.spoke]
section = "s"
line = { from = [0, 0, 0], to = [1, 0, 0] }
elements = 1
[[initial]]
on = "spoke"
velocity = [0, "2*s", 0]
angular_velocity = [0, 0, 2]
[[support]]
at = "spoke.start"
fix = "position"
move = { rx = 0, ry = 0, rz = "2*t" }
[[support]]
at = "spoke.end"
move = { x = "cos(2*t) - 1", y = "sin(2*t)", z = 0, rx = 0, ry = 0, rz = "2*t" }
[body.bead]
mass = 0.3
inertia = [1e-4, 1e-4, 1e-4]
at = [0.1, 0, 0]
velocity = [0, 0.2, 0]
[joint.sleeve]
type = "sleeve"
between = ["spoke", "bead"]
[analysis]
kind = "dynamic"
end_time = 1.4
time_step = 0.02
[[history]]
name = "sleeve"
at = "sleeve"
quantities = ["slide", "slide_rate", "force", "gap"]
)deck";

// Without gravity; a bead on a rod at rest, along x, held at both ends.
const std::string resting_rod = R"deck(
[section.s]
stiffness = { EA = 1e3, GAy = 500, GAz = 500, GJ = 4, EIy = 5, EIz = 5 }
inertia = { rhoA = 1, rhoIy = 0.01, rhoIz = 0.01 }
[rod.bar]
section = "s"
line = { from = [0, 0, 0], to = [2, 0, 0] }
elements = 1
[[support]]
at = "bar.start"
fix = "all"
[[support]]
at = "bar.end"
fix = "all"
[body.bead]
mass = 0.5
inertia = [1, 1, 1]
at = [1, 0, 0]
[joint.sleeve]
type = "sleeve"
between = ["bar", "bead"]
drive = "2*sin(3*t)"
spring = { stiffness = 4, damping = 0.6 }
[analysis]
kind = "dynamic"
end_time = 2
time_step = 0.02
[[history]]
name = "sleeve"
at = "sleeve"
quantities = ["slide", "slide_rate"]
)deck";

// x'' m + c x' + k x = 2 sin 3t from rest.
std::array<double, 2> swing(double t) {
    constexpr double m = 0.5, c = 0.6, k = 4.0, w = 3.0;
    const std::complex<double> i(0.0, 1.0);
    const std::complex<double> forced = 2.0 / (k - m * w * w + i * w * c);
    // x = Im(forced e^{iwt}) + e^{-dt} (A cos vt + B sin vt).
    const double d = c / (2.0 * m), v = std::sqrt(k / m - d * d);
    const double A = -forced.imag(), B = (d * A - w * forced.real()) / v;
    const auto e = forced * std::exp(i * w * t);
    const double decay = std::exp(-d * t), cosine = std::cos(v * t), sine = std::sin(v * t);
    return {e.imag() + decay * (A * cosine + B * sine),
            w * e.real() + decay * ((B * v - d * A) * cosine - (A * v + d * B) * sine)};
}

}  // namespace

TEST_CASE("A bead flies out along a turning rod at the order of every scheme", "[analyses][joints][sleeve]") {
    for (const char* name : {"newmark-simplified", "generalized-alpha", "sdirk-4"}) {
        const std::string scheme = name;
        INFO(scheme);
        const auto errors = [&](const std::string& step) {
            const Motion motion(turning_rod, with(scheme, step));
            CHECK(motion.largest("/histories/sleeve/gap") < 1e-11);
            const double slide = motion.at(1.4, "sleeve/slide")[0];
            const std::vector<double> force = motion.at(1.4, "sleeve/force");
            const double cosine = std::cos(2.8), sine = std::sin(2.8);
            CHECK(std::abs(force[0] * cosine + force[1] * sine) < 1e-9);
            const double across = force[1] * cosine - force[0] * sine;
            return std::array{std::abs(slide - (0.1 * std::cosh(2.8) - 0.1)),
                              std::abs(across - 1.2 * 0.2 * std::sinh(2.8))};
        };
        const auto coarse = errors("0.02"), fine = errors("0.01");
        const double ratio = scheme == "sdirk-4" ? 12.0 : 3.6;
        for (std::size_t i = 0; i < 2; ++i) CHECK(coarse[i] > ratio * fine[i]);
        CHECK(fine[0] < 1e-3);
    }
}

TEST_CASE("A bead on a rod swings between its spring and its drive", "[analyses][joints][sleeve]") {
    for (const std::string& scheme : schemes) {
        INFO(scheme);
        const auto errors = [&](const std::string& step) {
            const Motion motion(resting_rod, with(scheme, step));
            const auto [x, v] = swing(2.0);
            return std::array{std::abs(motion.at(2.0, "sleeve/slide")[0] - x),
                              std::abs(motion.at(2.0, "sleeve/slide_rate")[0] - v)};
        };
        const auto coarse = errors("0.04"), fine = errors("0.02");
        const double ratio = scheme == "sdirk-4" || scheme == "runge-kutta-4" ? 12.0 : 3.6;
        for (std::size_t i = 0; i < 2; ++i) CHECK(coarse[i] > ratio * fine[i]);
    }
}

TEST_CASE("A motor moves a bead along a rod, and works on it", "[analyses][joints][sleeve]") {
    std::string deck = replaced(resting_rod, "drive = \"2*sin(3*t)\"", "move = \"0.2*t^2\"");
    deck = replaced(deck, "spring = { stiffness = 4, damping = 0.6 }", "");
    deck = replaced(deck, "\"slide_rate\"", "\"slide_rate\", \"drive\"");
    const Motion motion(deck, with("sdirk-4", "0.02"));
    CHECK(motion.at(2.0, "sleeve/slide")[0] == Approx(0.8).epsilon(1e-10));
    CHECK(motion.at(1.0, "sleeve/drive")[0] == Approx(0.5 * 0.4).epsilon(1e-6));
    CHECK(motion.all("/ledger/external_work").back() == Approx(0.25 * 0.8 * 0.8).epsilon(1e-6));
    CHECK(motion.largest("/ledger/energy_error") < 1e-7);
}

TEST_CASE("A bead comes to rest by friction, and stays", "[analyses][joints][sleeve]") {
    std::string deck = replaced(resting_rod, "drive = \"2*sin(3*t)\"", "friction = { force = 0.5 }");
    deck = replaced(deck, "spring = { stiffness = 4, damping = 0.6 }", "");
    deck = replaced(deck, "at = [1, 0, 0]", "at = [1, 0, 0]\nvelocity = [1, 0, 0]");
    const Motion motion(deck, with("newmark-simplified", "0.005"));
    // v = 1 - t: half a metre, at t = 1.
    CHECK(motion.at(0.5, "sleeve/slide")[0] == Approx(0.375).epsilon(1e-4));
    CHECK(motion.at(2.0, "sleeve/slide")[0] == Approx(0.5).epsilon(1e-3));
    CHECK(motion.all("/ledger/dissipated_energy").back() == Approx(0.25).epsilon(1e-3));
}

// The rod drives the bead by 2 m ω ṡ, so s̈ = ω² s − 2 μ ω ṡ: s = A exp(a t) + B exp(b t), a and b = ω (−μ ±
// √(μ² + 1)).
TEST_CASE("Friction of a sleeve follows the force by which a turning rod drives a bead",
          "[analyses][joints][sleeve]") {
    const std::string deck = replaced(replaced(turning_rod, "\"force\", \"gap\"]", "\"friction\"]"),
                                      "between = [\"spoke\", \"bead\"]\n",
                                      "between = [\"spoke\", \"bead\"]\n"
                                      "friction = { coefficient = 0.3, stick = 1e-6 }\n");
    const double a = 2.0 * (-0.3 + std::sqrt(1.09)), b = 2.0 * (-0.3 - std::sqrt(1.09));
    const double A = -0.1 * b / (a - b), B = 0.1 * a / (a - b);
    const double slide = A * std::exp(a) + B * std::exp(b) - 0.1;
    const double rate = a * A * std::exp(a) + b * B * std::exp(b);
    for (const char* scheme : {"newmark-simplified", "generalized-alpha", "sdirk-4"}) {
        INFO(scheme);
        const Motion motion(deck, with(scheme, "0.005")), finer(deck, with(scheme, "0.0025"));
        CHECK(motion.at(1.0, "sleeve/slide")[0] == Approx(slide).epsilon(1e-3));
        CHECK(motion.at(1.0, "sleeve/friction")[0] == Approx(-0.3 * 0.3 * 2.0 * 2.0 * rate).epsilon(2e-3));
        // What friction takes is that of the force at the end of a step: of the first order.
        const char* error = "/ledger/energy_error";
        CHECK(motion.largest(error) < 1e-3);
        CHECK(finer.largest(error) == Approx(0.5 * motion.largest(error)).epsilon(0.1));
    }
}

TEST_CASE("A run with a sleeve that was stopped resumes to the last bit", "[analyses][joints][sleeve]") {
    for (const std::string& scheme : schemes) {
        INFO(scheme);
        const Motion whole(turning_rod, with(scheme, "0.02")), resumed(turning_rod, with(scheme, "0.02"), 37);
        for (const char* name :
             {"/histories/sleeve/slide", "/histories/sleeve/force", "/ledger/energy_error"})
            CHECK(whole.all(name) == resumed.all(name));
    }
}

TEST_CASE("A bead that leaves its rod ends the run", "[analyses][joints][sleeve]") {
    const Problem problem = test::read(turning_rod, {"analysis.end_time=2"});
    const sample::ScratchFolder folder;
    const RunSummary summary = run_problem(problem, folder / "run.vtkhdf");
    CHECK(summary.status != RunStatus::complete);
    CHECK_THAT(summary.reason, Contains("joint sleeve runs off the end of rod spoke at t = 1.5"));
}

TEST_CASE("A sleeve's motor has the time of its stage", "[analyses][joints][sleeve]") {
    std::string deck = replaced(resting_rod, "drive = \"2*sin(3*t)\"", "move = 0.2");
    deck = replaced(deck, "spring = { stiffness = 4, damping = 0.6 }", "");
    deck = replaced(
        deck,
        "[analysis]\nkind = \"dynamic\"",
        "[[stage]]\nname = \"push\"\nkind = \"static\"\nsteps = 4\n[[stage]]\nname = \"stay\"\nkind = "
        "\"dynamic\"");
    deck += "[[support]]\nat = \"bead\"\nfix = [\"rx\", \"ry\", \"rz\"]\n";
    const Motion motion(deck);
    CHECK(motion.at(-0.5, "sleeve/slide")[0] == Approx(0.1).epsilon(1e-12));
    CHECK(motion.at(2.0, "sleeve/slide")[0] == Approx(0.2).epsilon(1e-12));
}

TEST_CASE("An eye holds a rod as a support does", "[analyses][joints][sleeve]") {
    const auto deflect = [](const std::string& held) {
        std::string deck = replaced(resting_rod, "elements = 1", "elements = 6");
        deck = deck.substr(0, deck.find("[[support]]\nat = \"bar.end\"")) + held;
        deck +=
            "[[load]]\nat = \"bar.end\"\nforce = [0, -1e-5, 2e-5]\n[analysis]\nkind = \"static\"\n"
            "[[history]]\nname = \"tip\"\nat = \"bar.end\"\nquantities = [\"displacement\"]\n";
        return Motion(deck).at(1.0, "tip/displacement");
    };
    const std::vector<double> by_eye =
        deflect("[joint.eye]\ntype = \"sleeve\"\nbetween = [\"bar\", \"ground\"]\nat = [1, 0, 0]\n");
    const std::vector<double> by_support = deflect("[[support]]\nat = \"bar@0.5\"\nfix = [\"y\", \"z\"]\n");
    for (std::size_t i = 1; i < 3; ++i) CHECK(by_eye[i] == Approx(by_support[i]).epsilon(1e-6));
}

TEST_CASE("An eye's force is given along the rod, and across it in the axes of the section",
          "[analyses][joints][sleeve]") {
    std::string deck = replaced(resting_rod, "elements = 1", "elements = 6\ny_axis = [0, 0.6, 0.8]");
    deck = deck.substr(0, deck.find("[[support]]\nat = \"bar.end\"")) +
           "[joint.eye]\ntype = \"sleeve\"\nbetween = [\"bar\", \"ground\"]\nat = [1, 0, 0]\n"
           "[[load]]\nat = \"bar.end\"\nforce = [0, -1e-5, 2e-5]\n[analysis]\nkind = \"static\"\n"
           "[[history]]\nname = \"eye\"\nat = \"eye\"\nquantities = [\"force\", \"force_a\"]\n";
    const Motion motion(deck);
    const std::vector<double> global = motion.at(1.0, "eye/force"), own = motion.at(1.0, "eye/force_a");
    CHECK(std::abs(own[0]) < 1e-15);
    CHECK(own[1] == Approx(0.6 * global[1] + 0.8 * global[2]).epsilon(1e-4));
    CHECK(own[2] == Approx(-0.8 * global[1] + 0.6 * global[2]).epsilon(1e-4));
}

namespace {

// A cantilever of a bent section; a body at its middle node, which a moment turns.
const std::string carrier = R"deck(
[section.s]
stiffness = { EA = 1e5, GAy = 4e4, GAz = 4e4, GJ = 30, EIy = 40, EIz = 60 }
inertia = { rhoA = 1, rhoIy = 0.01, rhoIz = 0.01 }
[rod.bar]
section = "s"
line = { from = [0, 0, 0], to = [2, 0, 0] }
elements = 6
order = 2
[[support]]
at = "bar.start"
fix = "all"
[body.block]
mass = 0.5
inertia = [0.02, 0.03, 0.04]
at = [1, 0, 0]
[[load]]
at = "block"
force = [3, 4, -8]
moment = [5, -7, 9]
[[load]]
at = "bar.end"
force = [0, 6, 2]
[joint.collar]
between = BETWEEN
TYPE
[[history]]
name = "tip"
at = "bar.end"
quantities = ["displacement"]
[[history]]
name = "block"
at = "block"
quantities = ["displacement", "rotation_vector"]
[[history]]
name = "collar"
at = "collar"
quantities = ["force", "moment"]
)deck";

// The angle after this time of θ'' = −k sin θ from rest, by Runge and Kutta's method.
double swing_freely(double angle, double k, double time) {
    constexpr int steps = 4000;
    const double h = time / steps;
    std::array<double, 2> y{angle, 0.0};
    const auto rate = [&](const std::array<double, 2>& at, double part, const std::array<double, 2>& by) {
        return std::array{at[1] + part * h * by[1], -k * std::sin(at[0] + part * h * by[0])};
    };
    for (int i = 0; i < steps; ++i) {
        const auto k1 = rate(y, 0.0, {0.0, 0.0}), k2 = rate(y, 0.5, k1), k3 = rate(y, 0.5, k2),
                   k4 = rate(y, 1.0, k3);
        for (std::size_t j = 0; j < 2; ++j) y[j] += h / 6.0 * (k1[j] + 2.0 * k2[j] + 2.0 * k3[j] + k4[j]);
    }
    return y[0];
}

std::string carrier_with(const std::string& between, const std::string& type, const std::string& analysis) {
    return replaced(replaced(carrier, "BETWEEN", between), "TYPE", type) + analysis;
}

}  // namespace

// At a node the line and the section's axes are the node's: a collar that does not slide is a weld there.
TEST_CASE("A sleeve that neither slides nor turns is a weld", "[analyses][joints][sleeve]") {
    const std::string statics = "[analysis]\nkind = \"static\"\nsteps = 4\n";
    const std::string dynamics =
        "[analysis]\nkind = \"dynamic\"\nend_time = 0.2\ntime_step = 0.005\nintegrator = \"sdirk-4\"\n";
    for (const std::string& analysis : {statics, dynamics}) {
        const Motion sleeve(
            carrier_with("[\"bar\", \"block\"]", "type = \"sleeve\"\nturn = false\nmove = 0\n", analysis));
        const Motion weld(carrier_with("[\"bar@0.5\", \"block\"]", "type = \"weld\"\n", analysis));
        for (const char* name :
             {"tip/displacement", "block/displacement", "block/rotation_vector", "collar/moment"}) {
            INFO(name);
            const double end = analysis == statics ? 1.0 : 0.2;
            const Motion::Row one = sleeve.at(end, name), other = weld.at(end, name);
            for (std::size_t i = 0; i < 3; ++i) CHECK(one[i] == Approx(other[i]).epsilon(1e-7).margin(1e-9));
        }
    }
}

// On a straight rod at rest.
TEST_CASE("A sleeve that does not turn on a rod at rest is a slider", "[analyses][joints][sleeve]") {
    const std::string loads =
        "[[load]]\nat = \"bead\"\nforce = [\"0.2*sin(3*t)\", 2, -1]\nmoment = [\"2*t\", 1, "
        "-3]\n[[history]]\nname = "
        "\"held\"\nat = \"sleeve\"\nquantities = [\"moment\"]\n";
    const std::string sleeve =
        replaced(resting_rod, "type = \"sleeve\"", "type = \"sleeve\"\nturn = false") + loads;
    std::string slider =
        replaced(resting_rod, "type = \"sleeve\"", "type = \"slider\"\naxis = [1, 0, 0]") + loads;
    slider = replaced(slider, "[\"bar\", \"bead\"]", "[\"ground\", \"bead\"]");
    for (const std::string& scheme : schemes) {
        INFO(scheme);
        const Motion one(sleeve, with(scheme, "0.02")), other(slider, with(scheme, "0.02"));
        for (const char* name : {"sleeve/slide", "sleeve/slide_rate", "held/moment"}) {
            INFO(name);
            const Motion::Row a = one.at(2.0, name), b = other.at(2.0, name);
            for (std::size_t i = 0; i < a.size(); ++i) CHECK(a[i] == Approx(b[i]).epsilon(1e-9).margin(1e-9));
        }
    }
}

// A stiff, light half ring of radius 1 hangs from both ends; a collar slides on it from an angle of 1 rad off
// its lowest point. If it turns with the ring it is a pendulum of the inertia m R² + J, otherwise of m R².
TEST_CASE("A collar that does not turn on a ring turns with it", "[analyses][joints][sleeve]") {
    const std::string ring = R"deck(gravity = [0, 0, -9.81]
[section.s]
stiffness = { EA = 1e8, GAy = 1e8, GAz = 1e8, GJ = 1e8, EIy = 1e8, EIz = 1e8 }
inertia = { rhoA = 1e-3, rhoIy = 1e-5, rhoIz = 1e-5 }
[rod.ring]
section = "s"
arc = { from = [-1, 0, 0], through = [0, 0, -1], to = [1, 0, 0] }
elements = 16
order = 3
[[support]]
at = "ring.start"
fix = "all"
[[support]]
at = "ring.end"
fix = "all"
[body.block]
mass = 2
inertia = [0.9, 1.5, 0.7]
at = [0.8414709848078965, 0, -0.5403023058681398]
[joint.collar]
type = "sleeve"
between = ["ring", "block"]
turn = TURN
[analysis]
kind = "dynamic"
integrator = "sdirk-4"
end_time = 1
time_step = 0.01
[[history]]
name = "block"
at = "block"
quantities = ["position", "rotation_vector"]
[[history]]
name = "collar"
at = "collar"
quantities = ["slide", "gap"]
)deck";
    for (const bool turns : {true, false}) {
        INFO(turns);
        const Motion motion(replaced(ring, "TURN", turns ? "true" : "false"));
        const double angle = swing_freely(1.0, 2.0 * 9.81 / (turns ? 2.0 : 3.5), 1.0);
        const Motion::Row at = motion.at(1.0, "block/position");
        CHECK(std::atan2(at[0], -at[2]) == Approx(angle).epsilon(1e-5));
        CHECK(std::hypot(at[0], at[2]) == Approx(1.0).epsilon(1e-5));
        const Motion::Row turn = motion.at(1.0, "block/rotation_vector");
        CHECK(std::abs(turn[1]) == Approx(turns ? 0.0 : std::abs(angle - 1.0)).epsilon(1e-4).margin(1e-8));
        CHECK(motion.largest("/histories/collar/gap") < 1e-9);
    }
}

TEST_CASE("What a bound of a sleeve releases is lost where the return is too fast for a push",
          "[analyses][joints]") {
    // As for a slider: the bead starts 0.1 beyond its bound and leaves it at 1 m/s.
    const std::string deck = R"deck(
[section.s]
stiffness = { EA = 1e3, GAy = 500, GAz = 500, GJ = 4, EIy = 5, EIz = 5 }
inertia = { rhoA = 1, rhoIy = 0.01, rhoIz = 0.01 }
[rod.bar]
section = "s"
line = { from = [0, 0, 0], to = [2, 0, 0] }
elements = 1
[[support]]
at = ["bar.start", "bar.end"]
fix = "all"
[body.bead]
mass = 1
inertia = [1e-2, 1e-2, 1e-2]
at = [1, 0, 0]
velocity = [-1, 0, 0]
[joint.sleeve]
type = "sleeve"
between = ["bar", "bead"]
limits = { upper = -0.1, stiffness = 100, damping = 30 }
[analysis]
kind = "dynamic"
end_time = 0.2
time_step = 0.02
integrator = "newmark-simplified"
newton = { tolerance = 1e-13 }
)deck";
    const Motion motion(deck);
    CHECK(motion.all("/ledger/dissipated_energy").back() == Approx(0.5).epsilon(1e-11));
    CHECK(motion.largest("/ledger/energy_error") < 1e-11);
}
