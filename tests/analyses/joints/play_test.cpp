// Joints with clearance and gears with backlash: closed forms of equilibria, and a slider-crank with a loose
// pin against another integration.

#include <array>
#include <cmath>

#include "tools/recorded_motion.hpp"

using namespace gxrod;
using namespace gxrod::tools;
using test::replaced;

namespace {

using Motion = RecordedMotion;

// A pin that a soft bushing holds, pulled across its hole.
const std::string pulled = R"deck([body.pin]
mass = 1
inertia = [1, 1, 1]
at = [0, 0, 0]
[bushing.soft]
between = ["ground", "pin"]
stiffness = { x = 50, y = 50, z = 50, rx = 50, ry = 50, rz = 50 }
[joint.hole]
between = ["ground", "pin"]
TYPE
[[load]]
at = "pin"
force = ["30*t", "40*t", 0]
[analysis]
kind = "static"
steps = 4
newton = { tolerance = 1e-13 }
[[history]]
name = "hole"
at = "hole"
quantities = ["play", "force"]
[[history]]
name = "pin"
at = "pin"
quantities = ["position"]
)deck";

}  // namespace

TEST_CASE("A pin under a load is in its hole by the gap and the depth of contact", "[analyses][joints]") {
    // 50 N: (F + k c)/(k + 50) for a contact of the first power.
    const double linear = (50.0 + 2e6 * 1e-3) / (2e6 + 50.0);
    for (const char* type :
         {"type = \"ball\"\nclearance = { gap = 1e-3, stiffness = 2e6 }",
          "type = \"hinge\"\naxis = [0, 0, 3]\nclearance = { gap = 1e-3, stiffness = 2e6 }",
          "type = \"cylinder\"\naxis = [0, 0, 1]\nclearance = { gap = 1e-3, stiffness = "
          "2e6, damping = 3, friction = 0.3, radius = 0.1, slip_speed = 1 }"}) {
        INFO(type);
        const Motion motion(replaced(pulled, "TYPE", type));
        CHECK(motion.at(1.0, "hole/play")[0] == Approx(linear).epsilon(1e-10));
        const Motion::Row position = motion.at(1.0, "pin/position");
        CHECK(position[0] == Approx(0.6 * linear).epsilon(1e-10));
        CHECK(position[1] == Approx(0.8 * linear).epsilon(1e-10));
        CHECK(motion.at(1.0, "hole/force")[1] == Approx(-0.8 * (50.0 - 50.0 * linear)).epsilon(1e-10));
    }
    const Motion hertz(replaced(
        pulled, "TYPE", "type = \"ball\"\nclearance = { gap = 1e-3, stiffness = 3e7, exponent = 1.5 }"));
    const double play = hertz.at(1.0, "hole/play")[0];
    CHECK(3e7 * std::pow(play - 1e-3, 1.5) + 50.0 * play == Approx(50.0).epsilon(1e-10));
}

namespace {

// The slider-crank of Flores et al. (2006) at 5000 rpm, its pin loose in the slider.
const std::string loose_crank = R"deck([parameters]
w = "5000*2*pi/60"
[body.crank]
mass = 0.3
inertia = [1e-4, 1e-4, 1e-4]
at = [0.025, 0, 0]
velocity = [0, "0.025*w", 0]
angular_velocity = [0, 0, "w"]
[body.rod]
mass = 0.21
inertia = [2.5e-4, 2.5e-4, 2.5e-4]
at = [0.11, 0, 0]
velocity = [0, "0.025*w", 0]
angular_velocity = [0, 0, "-w*0.05/0.12"]
[body.slider]
mass = 0.14
inertia = [1e-4, 1e-4, 1e-4]
at = [0.17, 0, 0]
[joint.shaft]
type = "hinge"
between = ["ground", "crank"]
at = [0, 0, 0]
axis = [0, 0, 1]
move = "w*t"
[joint.crankpin]
type = "hinge"
between = ["crank", "rod"]
at = [0.05, 0, 0]
axis = [0, 0, 1]
[joint.wrist]
type = "hinge"
between = ["slider", "rod"]
at = [0.17, 0, 0]
axis = [0, 0, 1]
clearance = { CLEARANCE }
[joint.guide]
type = "slider"
between = ["ground", "slider"]
axis = [1, 0, 0]
[analysis]
kind = "dynamic"
end_time = 0.001
time_step = 5e-6
integrator = "radau-5"
adaptive = { tolerance = 1e-8, max_step = 1e-5 }
[[history]]
name = "wrist"
at = "wrist"
quantities = ["play"]
[[history]]
name = "slider"
at = "slider"
quantities = ["position", "velocity"]
)deck";

double rigid_slider(double t) {
    const double angle = 5000.0 * 2.0 * 3.14159265358979323846 / 60.0 * t;
    return 0.05 * std::cos(angle) + std::sqrt(0.12 * 0.12 - std::pow(0.05 * std::sin(angle), 2));
}

}  // namespace

// Two equations of motion, of the rod's angle and the slider, by DOP853 (scipy) with relative errors of
// 1e-12 and steps of 2 µs at most: contact begins at 0.227, 0.559, 0.717 and 0.977 ms.
TEST_CASE("A slider-crank with a loose pin moves as its equations by DOP853 say", "[analyses][joints]") {
    struct Sample {
        double time, play, position, velocity;
    };
    const std::string law =
        "gap = 5e-4, stiffness = 6.61e10, exponent = 1.5, restitution = 0.9, impact_speed = 1";
    const std::string deck = replaced(loose_crank, "CLEARANCE", law);
    for (const auto& [time, play, position, velocity] :
         {Sample{2e-4, 0.0003874321091569, 0.17, 0.0},
          Sample{2.5e-4, 0.0005697993361755, 0.1699652527622472, -4.4165671653502},
          Sample{5e-4, 0.0003774161899732, 0.1679231289668949, -8.3138792005314},
          Sample{1e-3, 0.0005326659501252, 0.1612127060220, -16.9356518648}}) {
        INFO("t = " << time);
        const Motion motion(deck, {"analysis.end_time=" + std::to_string(time)});
        CHECK(motion.all("/histories/wrist/play").back() == Approx(play).epsilon(1e-3));
        const Motion::Row positions = motion.all("/histories/slider/position");
        CHECK(positions[positions.size() - 3] == Approx(position).epsilon(1e-6));
        const Motion::Row velocities = motion.all("/histories/slider/velocity");
        CHECK(velocities[velocities.size() - 3] == Approx(velocity).epsilon(1e-4).margin(1e-10));
        const double kinetic = motion.largest("/ledger/kinetic_energy");
        CHECK(motion.largest("/ledger/energy_error") < 1e-4 * kinetic);
        if (time == 1e-3) CHECK(motion.all("/ledger/dissipated_energy").back() > 1e-3 * kinetic);
    }
}

TEST_CASE("A stiff pin without play moves as that of an ideal joint", "[analyses][joints]") {
    for (const auto& [law, error] : {std::pair{"gap = 1e-5, stiffness = 1e9, damping = 2e3", 2e-5},
                                     {"gap = 1e-7, stiffness = 1e10, damping = 2e4", 5e-7}}) {
        const Motion motion(replaced(loose_crank, "CLEARANCE", law));
        const Motion::Row positions = motion.all("/histories/slider/position");
        CHECK(std::abs(positions[positions.size() - 3] - rigid_slider(1e-3)) < error);
    }
}

namespace {

// The first turns as a motor says; a spring holds the second.
const std::string geared = R"deck([body.one]
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
FIRST
[joint.second]
type = "hinge"
between = ["two", "ground"]
axis = [-1, 0, 0]
spring = { stiffness = 3 }
[gear.g]
joints = ["first", "second"]
ratio = 0.2
backlash = 0.02
stiffness = 500
[analysis]
kind = "static"
steps = 4
newton = { tolerance = 1e-13 }
[[history]]
name = "second"
at = "second"
quantities = ["angle"]
[[history]]
name = "g"
at = "g"
quantities = ["drive", "play"]
)deck";

const std::string for_a_second =
    "kind = \"dynamic\"\nend_time = 1\ntime_step = 2e-3\nintegrator = \"sdirk-4\"";

}  // namespace

TEST_CASE("Geared shafts differ by half the backlash and what the teeth yield", "[analyses][joints][gear]") {
    // −3 q₂ − 500 (0.2 q₁ + q₂ − 0.01) = 0, likewise to the other side.
    for (const double turn : {0.5, -0.5}) {
        const Motion motion(replaced(geared, "FIRST", "move = \"" + std::to_string(turn) + "*t\""));
        const double second = -500.0 * (0.2 * turn - std::copysign(0.01, turn)) / 503.0;
        CHECK(motion.at(1.0, "second/angle")[0] == Approx(second).epsilon(1e-10));
        CHECK(motion.at(1.0, "g/play")[0] == Approx(0.2 * turn + second).epsilon(1e-9));
        CHECK(motion.at(1.0, "g/drive")[0] == Approx(3.0 * second).epsilon(1e-9));
    }
    const Motion within(replaced(geared, "FIRST", "move = \"0.049*t\""));
    CHECK(within.at(1.0, "second/angle")[0] == Approx(0.0).margin(1e-14));
    CHECK(within.at(1.0, "g/play")[0] == Approx(0.0098).epsilon(1e-12));
}

TEST_CASE("Teeth without backlash are springs, also where they rest", "[analyses][joints][gear]") {
    // Only the teeth hold the first shaft: 0.3 = 0.2 × 500 × play, and 500 × play on the spring of 3.
    const Motion motion(replaced(replaced(geared, "FIRST", "drive = 0.3"), "backlash = 0.02\n", ""));
    CHECK(motion.at(1.0, "g/play")[0] == Approx(0.003).epsilon(1e-9));
    CHECK(motion.at(1.0, "second/angle")[0] == Approx(-0.5).epsilon(1e-9));
}

TEST_CASE("A wheel is free within the backlash, and its impacts lose what their damping takes",
          "[analyses][joints][gear]") {
    // By a moment of 0.3 from rest, inertia 0.02: 0.2 q₁ = 0.01 after √(2 × 0.05 × 0.02/0.3) s.
    std::string deck = replaced(geared, "FIRST", "drive = 0.3");
    deck = replaced(deck, "kind = \"static\"\nsteps = 4", for_a_second);
    deck = replaced(deck, "stiffness = 500", "stiffness = 500\ndamping = 0.4");
    const Motion motion(deck);
    CHECK(motion.at(0.08, "g/play")[0] == Approx(0.2 * 0.5 * 15.0 * 0.0064).epsilon(1e-10));
    CHECK(motion.at(0.08, "second/angle")[0] == Approx(0.0).margin(1e-14));
    CHECK(motion.at(0.1, "g/drive")[0] < -0.01);
    CHECK(motion.all("/ledger/dissipated_energy").back() > 1e-3);
    CHECK(motion.largest("/ledger/energy_error") < 1e-4);
}

TEST_CASE("A ball that rolls and slips in its socket balances its energy", "[analyses][joints]") {
    const std::string socket = R"deck(gravity = [0, 0, -9.81]
[body.bob]
mass = 0.5
inertia = [1e-3, 1e-3, 1e-3]
at = [0, 0, 0]
velocity = [0.5, 0.2, 0]
angular_velocity = [5, 0, 8]
[joint.socket]
type = "ball"
between = ["ground", "bob"]
clearance = { gap = 0.05, stiffness = 2e4, damping = 5, friction = 0.3, radius = 0.1, slip_speed = 0.01 }
[analysis]
kind = "dynamic"
end_time = 1
time_step = STEP
integrator = "SCHEME"
[[history]]
name = "socket"
at = "socket"
quantities = ["play", "force"]
)deck";
    for (const auto& [scheme, error] :
         {std::pair{"newmark-simplified", 0.02}, {"sdirk-4", 2e-4}, {"generalized-alpha", 0.05}}) {
        INFO(scheme);
        const Motion motion(replaced(replaced(socket, "STEP", "2e-4"), "SCHEME", scheme));
        // Then it hops by less than a millimetre on the bottom of the socket.
        CHECK(motion.at(1.0, "socket/play")[0] == Approx(0.05).epsilon(0.02));
        CHECK(motion.all("/ledger/dissipated_energy").back() > 0.1);
        CHECK(motion.largest("/ledger/energy_error") < error);
    }
}

namespace {

// A block that starts 0.1 beyond the bound of its guide and leaves it so fast, 1 m/s, that the damper would
// pull.
const std::string thrown_block = R"deck([body.block]
mass = 1
inertia = [1, 1, 1]
at = [0, 0, 0]
velocity = [-1, 0, 0]
[joint.guide]
type = "slider"
between = ["ground", "block"]
axis = [1, 0, 0]
limits = { upper = -0.1, stiffness = 100, damping = 30 }
[analysis]
kind = "dynamic"
end_time = 0.2
time_step = STEP
integrator = "newmark-simplified"
newton = { tolerance = 1e-13 }
[[history]]
name = "block"
at = "block"
quantities = ["position"]
)deck";

}  // namespace

TEST_CASE("What a bound releases is lost where the return is too fast for a push", "[analyses][joints]") {
    for (const char* step : {"0.02", "0.05"}) {
        INFO(step);
        const Motion motion(replaced(thrown_block, "STEP", step));
        CHECK(motion.at(0.2, "block/position")[0] == Approx(-0.2).epsilon(1e-12));
        CHECK(motion.all("/ledger/dissipated_energy").back() == Approx(0.5).epsilon(1e-12));
        CHECK(motion.largest("/ledger/energy_error") < 1e-12);
    }
}

TEST_CASE("A bound that pushes all the time takes what its damper takes", "[analyses][joints]") {
    // q̈ = −100 (q + 0.1) − 30 q̇ from rest at 0; the push ends after 0.086 s, at the largest speed.
    constexpr double end = 0.08;
    std::string deck = replaced(thrown_block, "velocity = [-1, 0, 0]\n", "");
    deck = replaced(replaced(deck, "end_time = 0.2", "end_time = 0.08"), "STEP", "1e-3");
    const Motion motion(deck);
    const double r = -15.0 + std::sqrt(125.0), s = -15.0 - std::sqrt(125.0);
    const double slow = std::exp(r * end), fast = std::exp(s * end);
    const double depth = 0.1 * (r * fast - s * slow) / (r - s);
    const double rate = 0.1 * r * s * (fast - slow) / (r - s);
    CHECK(motion.at(end, "block/position")[0] == Approx(depth - 0.1).epsilon(1e-4));
    const double lost = 50.0 * (0.01 - depth * depth) - 0.5 * rate * rate;
    CHECK(motion.all("/ledger/dissipated_energy").back() == Approx(lost).epsilon(1e-4));
    CHECK(motion.largest("/ledger/energy_error") < 1e-12);
}

TEST_CASE("Teeth that rattle lose what their forces take", "[analyses][joints][gear]") {
    // Where they come back they push no more, since their damper would pull: hardly any backlash, so that
    // they begin to push where a step finds them.
    std::string deck = replaced(geared, "FIRST", "spring = { stiffness = 200 }");
    deck = replaced(deck, "at = [0, 0, 0]\n", "at = [0, 0, 0]\nangular_velocity = [0, 0, 3]\n");
    deck =
        replaced(deck, "backlash = 0.02\nstiffness = 500", "backlash = 1e-6\nstiffness = 500\ndamping = 20");
    deck = replaced(
        deck, "kind = \"static\"\nsteps = 4", "kind = \"dynamic\"\nend_time = 0.2\ntime_step = 5e-4");
    const Motion motion(deck);
    const Motion::Row forces = motion.all("/histories/g/drive");
    CHECK(std::ranges::count(forces, 0.0) > 100);
    CHECK(motion.all("/ledger/dissipated_energy").back() < 0.09);  // the energy at the start
    CHECK(motion.largest("/ledger/energy_error") < 1e-6);
}
