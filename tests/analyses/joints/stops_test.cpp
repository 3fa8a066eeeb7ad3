// Joints that can be slack, and stops: what they hold and let go has closed forms.

#include <array>
#include <cmath>

#include "tools/problem_run.hpp"
#include "tools/recorded_motion.hpp"

using namespace gxrod;
using namespace gxrod::tools;
using test::replaced;

namespace {

using Motion = RecordedMotion;
constexpr double g = 9.81;

std::string with_scheme(const std::string& deck, const std::string& scheme, const std::string& step) {
    return replaced(replaced(deck, "SCHEME", scheme), "STEP", step);
}

// A mass on a rope of length 1, half a length to the side of what holds it, thrown upwards.
const std::string thrown = R"deck(gravity = [0, 0, -9.81]
[body.stone]
mass = 2
inertia = [1e-3, 1e-3, 1e-3]
at = [0.5, 0, 0]
velocity = [1, 0, 2]
[joint.rope]
type = "distance"
between = ["ground", "stone"]
at_a = [0, 0, 0]
length = 1
slack = true
[analysis]
kind = "dynamic"
end_time = 0.8
time_step = STEP
integrator = "SCHEME"
[[history]]
name = "stone"
at = "stone"
quantities = ["position", "velocity"]
[[history]]
name = "rope"
at = "rope"
quantities = ["force", "gap"]
)deck";

struct Swing {
    double angle, rate;  // from the vertical downwards
};

// The free flight until the rope is taut, what is left of the velocity then, and the pendulum from there.
struct Thrown {
    double taut_at = 0.0;
    double lost = 0.0;  // energy
    Swing at_end{};
    double tension = 0.0;
};
Thrown throw_stone(double end) {
    const auto x = [](double t) { return 0.5 + t; };
    const auto z = [](double t) { return 2.0 * t - 0.5 * g * t * t; };
    double before = 0.0, after = 0.6;
    for (int i = 0; i < 60; ++i) {
        const double t = 0.5 * (before + after);
        (std::hypot(x(t), z(t)) < 1.0 ? before : after) = t;
    }
    Thrown all;
    const double t = all.taut_at = before;
    const double outwards = x(t) * 1.0 + z(t) * (2.0 - g * t);
    all.lost = 0.5 * 2.0 * outwards * outwards;
    // θ from −z towards x; along it (cos θ, sin θ).
    double angle = std::atan2(x(t), -z(t));
    double rate = std::cos(angle) * 1.0 + std::sin(angle) * (2.0 - g * t);
    constexpr int steps = 20000;
    const double h = (end - t) / steps;
    for (int i = 0; i < steps; ++i) {
        const double middle = rate - 0.5 * h * g * std::sin(angle);
        angle += h * middle;
        rate = middle - 0.5 * h * g * std::sin(angle);
    }
    all.at_end = {angle, rate};
    all.tension = 2.0 * (rate * rate + g * std::cos(angle));
    return all;
}

const std::vector<std::string> schemes{
    "newmark-simplified", "newmark-ibrahimbegovic", "generalized-alpha", "sdirk-4", "radau-5", "gauss-4"};

}  // namespace

TEST_CASE("A thrown stone flies until its rope is taut, then swings", "[analyses][joints][stops]") {
    const Thrown expected = throw_stone(0.8);
    REQUIRE(expected.taut_at > 0.1);
    for (const std::string& scheme : schemes) {
        INFO(scheme);
        const auto find_error = [&](const std::string& step) {
            const Motion motion(with_scheme(thrown, scheme, step));
            // It flies freely before.
            const Motion::Row flying = motion.at(0.1, "stone/position");
            CHECK(flying[0] == Approx(0.6).epsilon(1e-9));
            CHECK(flying[2] == Approx(0.2 - 0.5 * g * 0.01).epsilon(1e-9));
            const Motion::Row at = motion.at(0.8, "stone/position");
            CHECK(std::hypot(at[0], at[2]) == Approx(1.0).epsilon(1e-8));
            const Motion::Row force = motion.at(0.8, "rope/force");
            CHECK(std::hypot(force[0], force[2]) == Approx(expected.tension).epsilon(0.02));
            CHECK(force[2] > 0.0);
            CHECK(motion.all("/ledger/dissipated_energy").back() ==
                  Approx(expected.lost).epsilon(10.0 * std::stod(step)));
            CHECK(motion.largest("/ledger/energy_error") < 0.03);
            return std::atan2(at[0], -at[2]) - expected.at_end.angle;
        };
        const double coarse = find_error("0.01"), fine = find_error("0.001");
        CHECK(std::abs(coarse) < 0.02);
        CHECK(std::abs(fine) < 0.002);
    }
}

TEST_CASE("A stone on a taut rope goes slack where the tension ends", "[analyses][joints][stops]") {
    // From the lowest point, fast enough to pass the level of the hold and too slow for the top: slack where
    // v² = −g cos θ, with v² = v₀² − 2 g (1 − cos θ).
    const double speed = std::sqrt(3.5 * g);
    const double cosine = (2.0 - 3.5) / 3.0;
    std::string deck = replaced(thrown, "at = [0.5, 0, 0]", "at = [0, 0, -1]");
    deck = replaced(deck, "velocity = [1, 0, 2]", "velocity = [" + std::to_string(speed) + ", 0, 0]");
    for (const std::string& scheme : schemes) {
        INFO(scheme);
        const Motion motion(with_scheme(deck, scheme, "0.001"));
        const Motion::Row positions = motion.all("/histories/stone/position");
        const Motion::Row forces = motion.all("/histories/rope/force");
        double slack_at = 2.0;
        for (std::size_t i = 3; i < forces.size(); i += 3) {
            const double tension = std::hypot(forces[i], forces[i + 2]);
            if (tension > 0.0) continue;
            slack_at = -positions[i + 2] / std::hypot(positions[i], positions[i + 2]);
            break;
        }
        CHECK(slack_at == Approx(cosine).margin(0.01));
        // Then it falls freely, and nothing is lost before.
        CHECK(motion.largest("/ledger/energy_error") < 0.01);
    }
}

namespace {

// A mass on a guide, pushed to and fro between stops.
const std::string pushed = R"deck(
[body.block]
mass = 0.5
inertia = [1, 1, 1]
at = [0, 0, 0]
[joint.guide]
type = "slider"
between = ["ground", "block"]
axis = [1, 0, 0]
drive = "2*sin(pi*t)"
limits = { lower = -0.1, upper = 0.25 }
[analysis]
kind = "dynamic"
end_time = 2
time_step = STEP
integrator = "SCHEME"
[[history]]
name = "guide"
at = "guide"
quantities = ["slide", "slide_rate", "force_a"]
)deck";

}  // namespace

// x'' = 4 sin πt from rest: x = 4 (t/π − sin πt/π²) until 0.25, where it rests until the push turns at t = 1;
// back by x = 0.25 + 4 (−sin π(t−1) … )/π² likewise, until −0.1.
TEST_CASE("A block that is pushed against stops rests there until the push turns",
          "[analyses][joints][stops]") {
    constexpr double pi = 3.14159265358979323846;
    const auto way = [&](double t) { return 4.0 * (t / pi - std::sin(pi * t) / (pi * pi)); };
    for (const std::string& scheme : schemes) {
        INFO(scheme);
        const Motion motion(with_scheme(pushed, scheme, "0.002"));
        CHECK(motion.at(0.4, "guide/slide")[0] == Approx(way(0.4)).epsilon(1e-3));
        CHECK(motion.at(0.9, "guide/slide")[0] == Approx(0.25).epsilon(1e-8));
        CHECK(motion.at(0.9, "guide/slide_rate")[0] == Approx(0.0).margin(1e-8));
        // The stop holds the drive: its force is that of the joint along the axis, with the drive.
        CHECK(motion.at(0.9, "guide/force_a")[0] == Approx(0.0).margin(1e-6));
        CHECK(motion.at(1.3, "guide/slide")[0] == Approx(0.25 - way(0.3)).epsilon(0.01));
        CHECK(motion.at(2.0, "guide/slide")[0] == Approx(-0.1).epsilon(1e-8));
        CHECK(motion.largest("/ledger/energy_error") < 0.01);
    }
}

namespace {

// A cantilever under a load at its tip, 4 mm above a stop.
const std::string tipped = R"deck([section.s]
stiffness = { EA = 1e7, GAy = 1e7, GAz = 1e7, GJ = 100, EIy = 100, EIz = 100 }
inertia = { rhoA = 1, rhoIy = 1e-3, rhoIz = 1e-3 }
[rod.r]
section = "s"
line = { from = [0, 0, 0], to = [1, 0, 0] }
elements = 4
order = 3
[[support]]
at = "r.start"
fix = "all"
[joint.stop]
type = "free"
between = ["ground", "r.end"]
axis = [0, 0, 1]
limits = { slide = { lower = -0.004 } }
[[load]]
at = "r.end"
force = [0, 0, LOAD]
[[history]]
name = "tip"
at = "r.end"
quantities = ["displacement"]
[[history]]
name = "stop"
at = "stop"
quantities = ["force", "slide"]
)deck";

}  // namespace

TEST_CASE("A stop takes what a beam cannot once it is reached", "[analyses][joints][stops]") {
    // 3 EI/L³ = 300: 1.2 N close the gap, of 3 N the stop takes 1.8.
    const std::string deck = replaced(tipped, "LOAD", "\"-3*sin(pi*t)\"");
    for (const char* kind :
         {"kind = \"static\"\nsteps = 10\n", "kind = \"quasi-static\"\nend_time = 1\ntime_step = 0.1\n"}) {
        INFO(kind);
        const Motion motion(deck + "[analysis]\n" + kind);
        CHECK(motion.at(0.1, "tip/displacement")[2] ==
              Approx(-3.0 * std::sin(0.1 * M_PI) / 300).epsilon(1e-3));
        CHECK(motion.at(0.1, "stop/force")[2] == 0.0);
        CHECK(motion.at(0.5, "tip/displacement")[2] == Approx(-0.004).epsilon(1e-10));
        CHECK(motion.at(0.5, "stop/force")[2] == Approx(1.8).epsilon(1e-3));
        // And leaves it again.
        CHECK(motion.at(1.0, "tip/displacement")[2] == Approx(0.0).margin(1e-10));
        CHECK(motion.at(1.0, "stop/force")[2] == 0.0);
    }
}

TEST_CASE("A weight hangs on a rope that is taut from the start", "[analyses][joints][stops]") {
    const Motion motion(
        "gravity = [0, 0, -9.81]\n[body.weight]\nmass = 3\ninertia = [1, 1, 1]\nat = [0, 0, "
        "-2]\n[[support]]\nat = "
        "\"weight\"\nfix = [\"x\", \"y\", \"rotation\"]\n[joint.rope]\ntype = \"distance\"\nbetween = "
        "[\"ground\", "
        "\"weight\"]\nat_a = [0, 0, 0]\nslack = true\n[analysis]\nkind = \"static\"\n[[history]]\nname = "
        "\"rope\"\nat = \"rope\"\nquantities = [\"force\"]\n");
    CHECK(motion.at(1.0, "rope/force")[2] == Approx(3.0 * 9.81).epsilon(1e-9));
}

TEST_CASE("A run with stops resumes to the last bit", "[analyses][joints][stops]") {
    const std::string deck = with_scheme(pushed, "newmark-simplified", "0.01");
    const Motion whole(deck);
    for (const int steps : {40, 70, 130}) {
        INFO(steps);
        const Motion resumed(deck, {}, steps);
        CHECK(resumed.all("/histories/guide/slide") == whole.all("/histories/guide/slide"));
        CHECK(resumed.all("/ledger/dissipated_energy") == whole.all("/ledger/dissipated_energy"));
    }
}
