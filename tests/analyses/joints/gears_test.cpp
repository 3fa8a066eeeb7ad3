// Gears whose motion has a closed form.

#include <array>
#include <cmath>

#include "tools/recorded_motion.hpp"

using namespace gxrod;
using namespace gxrod::tools;
using test::replaced;

namespace {

using Motion = RecordedMotion;

const std::vector<std::string> schemes{
    "newmark-simplified", "newmark-ibrahimbegovic", "generalized-alpha", "sdirk-4", "runge-kutta-4"};

std::vector<std::string> with(const std::string& scheme) {
    std::vector<std::string> overrides{"analysis.integrator=\"" + scheme + "\""};
    if (scheme != "runge-kutta-4") overrides.push_back("analysis.newton.tolerance=1e-12");
    return overrides;
}

// The first turns by a moment of 1, the second five times slower, back.
const std::string two_wheels = R"(
[body.one]
mass = 1
inertia = [0.02, 0.03, 0.02]
at = [0, 0, 0]
[body.two]
mass = 2
inertia = [0.5, 0.4, 0.3]
at = [1, 0, 0]
[joint.first]
type = "hinge"
between = ["ground", "one"]
axis = [0, 0, 1]
drive = 1
[joint.second]
type = "hinge"
between = ["two", "ground"]
axis = [-1, 0, 0]
[gear.g]
joints = ["first", "second"]
ratio = 0.2
[analysis]
kind = "dynamic"
end_time = 1
time_step = 0.01
[[history]]
name = "first"
at = "first"
quantities = ["angle", "angle_rate"]
[[history]]
name = "second"
at = "second"
quantities = ["angle", "angle_rate", "moment"]
[[history]]
name = "g"
at = "g"
quantities = ["drive", "gap"]
)";

// A pinion of radius 0.1, driven by 1, and a rack on a spring of 30 on a slider: x'' (m + J/r^2) + k x =
// -1/r.
const std::string rack = R"(
[body.pinion]
mass = 1
inertia = [0.02, 0.02, 0.02]
at = [0, 0, 0]
[body.rack]
mass = 3
inertia = [1, 1, 1]
at = [0, -0.1, 0]
[joint.axle]
type = "hinge"
between = ["ground", "pinion"]
axis = [0, 0, 1]
drive = 1
[joint.guide]
type = "cylinder"
between = ["ground", "rack"]
axis = [1, 0, 0]
spring = { slide = { stiffness = 30 } }
[gear.g]
joints = ["axle", "guide.slide"]
ratio = 0.1
[analysis]
kind = "dynamic"
end_time = 2
time_step = 0.02
[[history]]
name = "axle"
at = "axle"
quantities = ["angle"]
[[history]]
name = "guide"
at = "guide"
quantities = ["slide", "slide_rate"]
[[history]]
name = "g"
at = "g"
quantities = ["drive", "gap"]
)";

// A planet on a carrier rolls about a sun that rests, twice as large.
const std::string planet = R"(
[body.carrier]
mass = 1
inertia = [0.2, 0.2, 0.3]
at = [0, 0, 0]
[body.planet]
mass = 2
inertia = [0.03, 0.03, 0.05]
at = [0.3, 0, 0]
[joint.centre]
type = "hinge"
between = ["ground", "carrier"]
axis = [0, 0, 1]
drive = 2
[joint.axle]
type = "hinge"
between = ["carrier", "planet"]
axis = [0, 0, 1]
at = [0.3, 0, 0]
[gear.g]
joints = ["centre", "axle"]
ratio = -2
[analysis]
kind = "dynamic"
end_time = 1
time_step = 0.02
[[history]]
name = "centre"
at = "centre"
quantities = ["angle"]
[[history]]
name = "axle"
at = "axle"
quantities = ["angle"]
[[history]]
name = "planet"
at = "planet"
quantities = ["angular_velocity"]
[[history]]
name = "g"
at = "g"
quantities = ["drive", "gap"]
)";

}  // namespace

TEST_CASE("Two wheels in gear turn as one inertia", "[analyses][joints][gear]") {
    // The axis of the second is -x from its B, the ground: its angle is that of the wheel about x.
    for (const std::string& scheme : schemes) {
        INFO(scheme);
        const Motion motion(two_wheels, with(scheme));
        // The quaternions of runge-kutta-4 are of order 4.
        const double tolerance = scheme == "runge-kutta-4" ? 1e-6 : 1e-10;
        CHECK(motion.at(1.0, "first/angle")[0] == Approx(12.5).epsilon(tolerance));
        CHECK(motion.at(1.0, "second/angle")[0] == Approx(-2.5).epsilon(tolerance));
        CHECK(motion.at(0.5, "first/angle_rate")[0] == Approx(12.5).epsilon(1e-10));
        CHECK(motion.at(0.5, "second/angle_rate")[0] == Approx(-2.5).epsilon(1e-10));
        for (const double time : {0.01, 0.5, 1.0})
            CHECK(motion.at(time, "g/drive")[0] == Approx(-2.5).epsilon(1e-8));
        CHECK(motion.largest("/histories/g/gap") < 1e-12);
        CHECK(motion.largest("/ledger/external_work") == Approx(12.5).epsilon(1e-9));
        CHECK(motion.largest("/ledger/energy_error") < 1e-10);
    }
}

TEST_CASE("A rack on a spring swings with its pinion at the order of every scheme",
          "[analyses][joints][gear]") {
    constexpr double mass = 3.0 + 0.02 / 0.01, k = 30.0, force = -10.0;
    const double omega = std::sqrt(k / mass);
    const double slide = force / k * (1.0 - std::cos(2.0 * omega));
    const double acceleration = force / mass * std::cos(2.0 * omega);
    for (const std::string& scheme : schemes) {
        INFO(scheme);
        const auto errors = [&](const std::string& step) {
            std::vector<std::string> overrides = with(scheme);
            overrides.push_back("analysis.time_step=" + step);
            const Motion motion(rack, overrides);
            CHECK(motion.largest("/histories/g/gap") < 1e-12);
            CHECK(motion.at(2.0, "axle/angle")[0] ==
                  Approx(-10.0 * motion.at(2.0, "guide/slide")[0]).epsilon(1e-11));
            const double on_rack = 3.0 * acceleration + k * slide;
            return std::array{std::abs(motion.at(2.0, "guide/slide")[0] - slide),
                              std::abs(motion.at(2.0, "g/drive")[0] - on_rack)};
        };
        const auto coarse = errors("0.04"), fine = errors("0.02");
        const double ratio = scheme == "sdirk-4" || scheme == "runge-kutta-4" ? 12.0 : 3.6;
        for (std::size_t i = 0; i < 2; ++i) CHECK(coarse[i] > ratio * fine[i]);
    }
}

TEST_CASE("A planet rolls about its sun", "[analyses][joints][gear]") {
    // Carrier and planet as one inertia: 0.3 + 2 (0.3)^2 + 0.05 (1 + 2)^2.
    const double alpha = 2.0 / (0.3 + 0.18 + 0.45);
    for (const std::string& scheme : schemes) {
        INFO(scheme);
        const auto errors = [&](const std::string& step) {
            std::vector<std::string> overrides = with(scheme);
            overrides.push_back("analysis.time_step=" + step);
            const Motion motion(planet, overrides);
            CHECK(motion.largest("/histories/g/gap") < 1e-12);
            const double angle = motion.at(1.0, "centre/angle")[0];
            CHECK(motion.at(1.0, "axle/angle")[0] == Approx(2.0 * angle).epsilon(1e-10));
            // On the planet against the carrier.
            return std::array{std::abs(angle - 0.5 * alpha),
                              std::abs(motion.at(1.0, "g/drive")[0] - 0.05 * 3.0 * alpha)};
        };
        const auto coarse = errors("0.02"), fine = errors("0.01");
        CHECK(fine[0] < 1e-4);
        CHECK(fine[1] < 1e-4);
        for (std::size_t i = 0; i < 2; ++i) CHECK((fine[i] < 1e-9 || coarse[i] > 3.5 * fine[i]));
    }
}

TEST_CASE("A motor turns a geared wheel", "[analyses][joints][gear]") {
    const std::string moved = replaced(two_wheels, "drive = 1", "move = \"12.5*t^2\"");
    for (const std::string& scheme : schemes) {
        INFO(scheme);
        const Motion motion(replaced(moved, "[\"angle\", \"angle_rate\"]", "[\"angle\", \"drive\"]"),
                            with(scheme));
        CHECK(motion.at(1.0, "second/angle")[0] == Approx(-2.5).epsilon(1e-10));
        CHECK(motion.at(1.0, "first/drive")[0] == Approx(1.0).epsilon(1e-8));
        CHECK(motion.at(1.0, "g/drive")[0] == Approx(-2.5).epsilon(1e-8));
    }
}

TEST_CASE("A gear in statics holds moments in the ratio of its turns", "[analyses][joints][gear]") {
    std::string deck = replaced(two_wheels, "drive = 1", "spring = { stiffness = 4 }");
    deck = replaced(deck, "axis = [-1, 0, 0]", "axis = [-1, 0, 0]\ndrive = \"60*t\"");
    deck = replaced(deck, "\"dynamic\"\nend_time = 1\ntime_step = 0.01", "\"static\"\nsteps = 4");
    deck = replaced(deck, "\"angle\", \"angle_rate\"", "\"angle\"");
    deck = replaced(deck, "\"angle\", \"angle_rate\"", "\"angle\"");
    const Motion motion(deck);
    // 4 q1 = -0.2 * 60, q2 = -0.2 q1.
    CHECK(motion.at(1.0, "first/angle")[0] == Approx(-3.0).epsilon(1e-11));
    CHECK(motion.at(1.0, "second/angle")[0] == Approx(0.6).epsilon(1e-11));
    CHECK(motion.at(1.0, "g/drive")[0] == Approx(-60.0).epsilon(1e-11));
    CHECK(motion.largest("/histories/g/gap") < 1e-12);
    // The spring's energy is what the drive gave.
    CHECK(motion.largest("/ledger/external_work") == Approx(18.0).epsilon(1e-10));
}

TEST_CASE("A run of gears that was stopped resumes to the last bit", "[analyses][joints][gear]") {
    for (const std::string& scheme : schemes) {
        INFO(scheme);
        const Motion whole(rack, with(scheme)), resumed(rack, with(scheme), 37);
        for (const char* name : {"/histories/guide/slide", "/histories/g/drive", "/ledger/external_work"})
            CHECK(whole.all(name) == resumed.all(name));
    }
}
