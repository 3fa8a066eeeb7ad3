// Joints that hold some directions, that hold in some stages, and that break.

#include <cmath>

#include "tools/problem_run.hpp"
#include "tools/recorded_motion.hpp"

using namespace gxrod;
using namespace gxrod::tools;
using test::replaced;

namespace {

using Motion = RecordedMotion;

// A body that turns and has a velocity, under gravity.
const std::string bead = R"deck(gravity = [0, 0, -9.81]
[body.bead]
mass = 2
inertia = [0.3, 0.3, 0.3]
at = [1, 2, 3]
velocity = VELOCITY
angular_velocity = TURN
[joint.guide]
type = "generic"
between = ["ground", "bead"]
axis = [3, 0, -4]
y_axis = [0, 1, 0]
holds = HOLDS
[analysis]
kind = "dynamic"
end_time = 0.5
time_step = 0.005
integrator = "SCHEME"
[[history]]
name = "bead"
at = "bead"
quantities = ["displacement", "velocity", "angular_velocity"]
[[history]]
name = "guide"
at = "guide"
quantities = ["force_a", "moment_a", "gap"]
)deck";

std::string bead_with(const std::string& holds,
                      const std::string& velocity,
                      const std::string& turn,
                      const std::string& scheme) {
    return replaced(replaced(replaced(replaced(bead, "HOLDS", holds), "VELOCITY", velocity), "TURN", turn),
                    "SCHEME",
                    scheme);
}

// A bar on two props, of which the one at its end breaks or rests.
const std::string propped = R"deck([section.s]
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
OPTIONS
[[load]]
at = "r.end"
force = [0, 0, "4*t"]
[[history]]
name = "tip"
at = "r.end"
quantities = ["displacement"]
[[history]]
name = "prop"
at = "prop"
quantities = ["force", "holds"]
)deck";

std::string propped_with(const std::string& options, const std::string& analysis) {
    return replaced(propped, "OPTIONS", options) + analysis;
}

double tip_without_prop(double force) {
    std::string deck = propped_with("", "[analysis]\nkind = \"static\"\nsteps = 10\n");
    const std::size_t from = deck.find("[joint.prop]"), to = deck.find("[[load]]");
    deck.erase(from, to - from);
    deck.erase(deck.find("[[history]]\nname = \"prop\""), std::string::npos);
    deck += "[analysis]\nkind = \"static\"\nsteps = 10\n";
    deck = replaced(deck, "\"4*t\"", "\"" + std::to_string(force) + "*t\"");
    return Motion(deck).at(1.0, "tip/displacement")[2];
}

}  // namespace

// Down a slope of 4 in 5, g 4/5 along it.
TEST_CASE("A bead slides along a line and turns as it likes", "[analyses][joints]") {
    for (const char* scheme : {"newmark-simplified", "generalized-alpha", "sdirk-4", "radau-5"}) {
        INFO(scheme);
        const Motion motion(bead_with("[\"y\", \"z\"]", "[0, 0, 0]", "[1, 2, 3]", scheme));
        const double way = 0.5 * 9.81 * 0.8 * 0.25;
        const auto moved = motion.at(0.5, "bead/displacement");
        CHECK(moved[0] == Approx(0.6 * way).epsilon(1e-5));
        CHECK(moved[1] == Approx(0.0).margin(1e-10));
        CHECK(moved[2] == Approx(-0.8 * way).epsilon(1e-5));
        const auto turn = motion.at(0.5, "bead/angular_velocity");
        for (int i = 0; i < 3; ++i) CHECK(turn[i] == Approx(i + 1.0).epsilon(1e-9));
        // Weight across the slope, held along z of the joint.
        const auto force = motion.at(0.5, "guide/force_a");
        CHECK(force[0] == Approx(0.0).margin(1e-9));
        CHECK(std::abs(force[2]) == Approx(2.0 * 9.81 * 0.6).epsilon(1e-5));
    }
}

TEST_CASE("A point stays on a plane and slides in it", "[analyses][joints]") {
    const Motion motion(bead_with("\"x\"", "[0.8, 1, 0.6]", "[0, 0, 0]", "sdirk-4"));
    // Along (4, 0, 3)/5 gravity is −g 3/5.
    const double along = 0.5 - 0.5 * 9.81 * 0.6 * 0.25;
    const auto moved = motion.at(0.5, "bead/displacement");
    CHECK(moved[0] == Approx(0.8 * along).epsilon(1e-8));
    CHECK(moved[1] == Approx(0.5).epsilon(1e-8));
    CHECK(moved[2] == Approx(0.6 * along).epsilon(1e-8));
    CHECK(motion.largest("/histories/guide/gap") < 1e-10);
}

// What is held of the angular velocity is taken by the moment.
TEST_CASE("Parallel axes fall freely and turn about their axis", "[analyses][joints]") {
    const Motion motion(bead_with("[\"ry\", \"rz\"]", "[0, 0, 1]", "[1.2, 0, -1.6]", "sdirk-4"));
    const auto moved = motion.at(0.5, "bead/displacement");
    CHECK(moved[2] == Approx(0.5 - 0.5 * 9.81 * 0.25).epsilon(1e-9));
    const auto turn = motion.at(0.5, "bead/angular_velocity");
    CHECK(turn[0] == Approx(1.2).epsilon(1e-9));
    CHECK(turn[2] == Approx(-1.6).epsilon(1e-9));
}

TEST_CASE("A joint lets go in the stages that it does not name", "[analyses][joints]") {
    const std::string stages = R"deck([[stage]]
name = "push"
kind = "static"
steps = 5
[[stage]]
name = "free"
kind = "static"
steps = 5
)deck";
    const Motion motion(propped_with("stages = \"push\"", stages));
    const auto before = motion.at(1.0, "prop/force");
    CHECK(before[2] == Approx(-4.0).epsilon(1e-9));
    CHECK(motion.at(1.0, "tip/displacement")[2] == Approx(0.0).margin(1e-9));
    CHECK(motion.at(2.0, "prop/holds")[0] == 0.0);
    CHECK(motion.at(2.0, "prop/force")[2] == 0.0);
    CHECK(motion.at(2.0, "tip/displacement")[2] == Approx(tip_without_prop(4.0)).epsilon(1e-6));
}

TEST_CASE("A body that a joint holds falls when the joint lets go", "[analyses][joints]") {
    const std::string deck = R"deck(gravity = [0, 0, -10]
[body.b]
mass = 2
inertia = [1, 1, 1]
at = [0, 0, 0]
[joint.hook]
type = "weld"
between = ["ground", "b"]
stages = ["hang", "caught"]
[[history]]
name = "b"
at = "b"
quantities = ["displacement"]
[[history]]
name = "hook"
at = "hook"
quantities = ["force", "holds"]
[[stage]]
name = "hang"
kind = "dynamic"
end_time = 0.5
time_step = 0.05
[[stage]]
name = "fall"
kind = "dynamic"
end_time = 1
time_step = 0.05
)deck";
    const std::string falls = replaced(deck, "[\"hang\", \"caught\"]", "\"hang\"");
    for (const char* scheme : {"newmark-simplified", "generalized-alpha", "sdirk-4", "radau-5"}) {
        INFO(scheme);
        const std::string integrator = std::string("integrator = \"") + scheme + "\"\n";
        const Motion motion(replaced(replaced(falls, "end_time = 1\n", "end_time = 1\n" + integrator),
                                     "end_time = 0.5\n",
                                     "end_time = 0.5\n" + integrator));
        CHECK(motion.at(0.5, "hook/force")[2] == Approx(20.0).epsilon(1e-9));
        CHECK(motion.at(1.5, "b/displacement")[2] == Approx(-5.0).epsilon(1e-9));
        CHECK(motion.largest("/ledger/energy_error") < 1e-8);
    }
    // It is not where it was when it is to hold again.
    const std::string again =
        deck + "[[stage]]\nname = \"caught\"\nkind = \"dynamic\"\nend_time = 1\ntime_step = 0.05\n";
    const sample::ScratchFolder folder;
    const RunSummary summary = run_problem(test::read(again), folder / "run.vtkhdf");
    CHECK(summary.status == RunStatus::failed);
    CHECK_THAT(summary.reason,
               Catch::Contains("joint hook is to hold from here on, and is open by a distance of 5"));
}

TEST_CASE("A joint breaks in statics, and what it held is carried otherwise", "[analyses][joints]") {
    const std::string options = "breaks = { force = 2.1 }";
    for (const char* kind : {"static\"\nsteps = 20\n", "quasi-static\"\nend_time = 1\ntime_step = 0.05\n"}) {
        INFO(kind);
        const Motion motion(propped_with(options, std::string("[analysis]\nkind = \"") + kind));
        CHECK(motion.at(0.5, "prop/holds")[0] == 1.0);
        CHECK(motion.at(0.5, "prop/force")[2] == Approx(-2.0).epsilon(1e-6));
        CHECK(motion.at(0.55, "prop/holds")[0] == 0.0);
        CHECK(motion.at(1.0, "prop/force")[2] == 0.0);
        CHECK(motion.at(1.0, "tip/displacement")[2] == Approx(tip_without_prop(4.0)).epsilon(1e-6));
    }
    const Motion whole(
        propped_with("breaks = { force = 2.1 }", "[analysis]\nkind = \"static\"\nsteps = 20\n"));
    const Motion resumed(
        propped_with("breaks = { force = 2.1 }", "[analysis]\nkind = \"static\"\nsteps = 20\n"), {}, 14);
    CHECK(resumed.all("/histories/tip/displacement") == whole.all("/histories/tip/displacement"));
    CHECK(resumed.all("/histories/prop/holds") == whole.all("/histories/prop/holds"));
}

// Under 10 t the weld holds 5 until t = ½; from there v = 5 (t² − ¼)/2, m = 2. It breaks at the end of a
// step, so errors are of the first order.
TEST_CASE("A body that breaks loose moves from there", "[analyses][joints]") {
    const std::string deck = R"deck([body.b]
mass = 2
inertia = [1, 1, 1]
at = [0, 0, 0]
[joint.bond]
type = "weld"
between = ["ground", "b"]
breaks = { force = 5 }
[[load]]
at = "b"
force = ["10*t", 0, 0]
[analysis]
kind = "dynamic"
end_time = 1
time_step = STEP
integrator = "SCHEME"
[[history]]
name = "b"
at = "b"
quantities = ["velocity"]
)deck";
    for (const char* scheme :
         {"newmark-simplified", "newmark-ibrahimbegovic", "generalized-alpha", "sdirk-4", "radau-5"}) {
        INFO(scheme);
        const auto error = [&](const char* step) {
            const Motion motion(replaced(replaced(deck, "STEP", step), "SCHEME", scheme));
            CHECK(motion.largest("/ledger/energy_error") < 0.05);
            return std::abs(motion.at(1.0, "b/velocity")[0] - 1.875);
        };
        const double coarse = error("0.02"), fine = error("0.0025");
        CHECK(coarse < 0.08);
        CHECK(fine < 0.2 * coarse + 1e-9);
    }
}

TEST_CASE("What a joint's spring stores is lost when the joint breaks", "[analyses][joints]") {
    // Wound by t, the hinge's spring has the moment 2 t; it holds the force 6 t of the load.
    const std::string deck = R"deck([body.b]
mass = 2
inertia = [1, 1, 1]
at = [0, 0, 0]
[joint.pin]
type = "hinge"
between = ["ground", "b"]
axis = [0, 0, 1]
spring = { stiffness = 2 }
breaks = { force = 3.05 }
[[load]]
at = "b"
force = ["6*t", 0, 0]
moment = [0, 0, 0.3]
[analysis]
kind = "dynamic"
end_time = 1
time_step = 0.01
integrator = "sdirk-4"
)deck";
    const Motion motion(deck);
    const auto strain = motion.all("/ledger/strain_energy"), lost = motion.all("/ledger/dissipated_energy");
    CHECK(strain.at(50) > 0.0);
    CHECK(strain.back() == 0.0);
    CHECK(lost.at(50) == 0.0);
    CHECK(lost.back() > 0.5 * strain.at(50));
    CHECK(motion.largest("/ledger/energy_error") < 1e-6);
}
