// Cams: an eccentric disc, whose follower has a closed form, a cam that a moment drives, and followers that
// lift.

#include <cmath>

#include "tools/problem_run.hpp"
#include "tools/recorded_motion.hpp"

using namespace gxrod;
using namespace gxrod::tools;
using test::replaced;

namespace {

using Motion = RecordedMotion;
constexpr double weight = 0.5 * 9.81;

// A tappet above a cam, on a guide with a spring.
const std::string tappet_on_cam = R"deck(gravity = [0, -9.81, 0]
[body.cam]
mass = 0.4
inertia = [0.01, 0.01, 0.02]
at = [0, 0, 0]
[body.tappet]
mass = 0.5
inertia = [1e-4, 1e-4, 1e-4]
at = [0, HEIGHT, 0]
[joint.shaft]
type = "hinge"
between = ["ground", "cam"]
axis = [0, 0, 1]
SHAFT
[joint.guide]
type = "slider"
between = ["ground", "tappet"]
axis = [0, 1, 0]
GUIDE
[joint.contact]
type = "cam"
between = ["cam", "tappet"]
axis = [0, 0, 1]
x_axis = X_AXIS
curve = { radius = "RADIUS" }
roller = 0.01
LIFTS
[analysis]
kind = "dynamic"
end_time = 0.5
time_step = 0.001
integrator = "SCHEME"
newton = { tolerance = 1e-12 }
[[history]]
name = "tappet"
at = "tappet"
quantities = ["displacement", "velocity"]
[[history]]
name = "contact"
at = "contact"
quantities = ["normal_force", "curve_place", "curve_gap", "force", "gap"]
[[history]]
name = "shaft"
at = "shaft"
quantities = ["angle", "angle_rate", "drive"]
)deck";

const char* const disc = "0.02*cos(angle) + sqrt(0.05^2 - (0.02*sin(angle))^2)";
const char* const spring_on_guide = "spring = { stiffness = 2000, rest = -0.02 }";

// The disc, its centre below the shaft at t = 0.
std::string disc_deck(const std::string& scheme, const std::string& shaft = "move = \"20*t^2\"") {
    std::string deck = replaced(replaced(tappet_on_cam, "HEIGHT", "0.04"), "X_AXIS", "[0, -1, 0]");
    deck = replaced(replaced(deck, "RADIUS", disc), "SCHEME", scheme);
    return replaced(replaced(replaced(deck, "SHAFT", shaft), "GUIDE", spring_on_guide), "LIFTS", "");
}

// An explicit scheme has no Newton's method.
std::string without_newton(const std::string& deck, const std::string& scheme) {
    return scheme == "runge-kutta-4" ? replaced(deck, "newton = { tolerance = 1e-12 }\n", "") : deck;
}

// The height of its tappet at the angle a of the shaft, and its derivatives.
struct Lift {
    double value, slope, bend;
};
Lift lift_of_disc(double a) {
    const double e = 0.02, reach = 0.06;
    const double root = std::sqrt(reach * reach - std::pow(e * std::sin(a), 2));
    const double product = e * e * std::sin(a) * std::cos(a);
    return {-e * std::cos(a) + root,
            e * std::sin(a) - product / root,
            e * std::cos(a) - e * e * std::cos(2.0 * a) / root - product * product / std::pow(root, 3)};
}

// A cam without symmetry, driven by a moment.
std::string driven_deck(const std::string& scheme) {
    std::string deck = replaced(replaced(tappet_on_cam, "HEIGHT", "0.066"), "X_AXIS", "[0, 1, 0]");
    deck = replaced(deck, "RADIUS", "0.05 + 0.006*cos(2*angle) + 0.004*sin(angle)^3");
    deck = replaced(replaced(deck, "SCHEME", scheme), "SHAFT", "drive = 1.5");
    return replaced(replaced(deck, "GUIDE", spring_on_guide), "LIFTS", "");
}

// Of that cam at t = 0.2, 0.35 and 0.5 by Lagrange's equation in the angle of the point of contact, by
// DOP853 with a tolerance of 1e-13: the tappet's displacement and velocity, the shaft's angle and rate, and
// the normal force.
struct Driven {
    double time, displacement, velocity, angle, rate, force;
};
constexpr Driven driven[]{
    {0.2, -0.01572860110356, 0.08269302361205, 1.682706249527, 17.266307596394, 19.7682345224},
    {0.35, -0.00744989715463, 0.10202986964707, 5.010098806004, 27.913406007768, 34.7578987460},
    {0.5, -0.00290315379524, -0.30777339393032, 10.011259606078, 38.878202264034, 36.8355393042}};

}  // namespace

TEST_CASE("A disc off its shaft moves a tappet as its closed form says", "[analyses][joints][cams]") {
    for (const std::string scheme : {"newmark-simplified",
                                     "newmark-ibrahimbegovic",
                                     "generalized-alpha",
                                     "runge-kutta-4",
                                     "sdirk-4",
                                     "radau-5",
                                     "gauss-4"}) {
        INFO(scheme);
        const Motion motion(without_newton(disc_deck(scheme), scheme));
        for (const double t : {0.1, 0.3, 0.5}) {
            const double angle = 20.0 * t * t, rate = 40.0 * t;
            const Lift lift = lift_of_disc(angle);
            CHECK(motion.at(t, "tappet/displacement")[1] == Approx(lift.value - 0.04).margin(1e-11));
            CHECK(motion.at(t, "tappet/velocity")[1] == Approx(lift.slope * rate).margin(1e-4));
            CHECK(std::abs(motion.at(t, "contact/curve_gap")[0]) < 1e-11);
            // What spring, weight and inertia ask for, along the normal.
            const double acceleration = lift.bend * rate * rate + lift.slope * 40.0;
            const double upwards = 0.5 * acceleration + weight + 2000.0 * (lift.value - 0.04 + 0.02);
            const double steepness = (lift.value + 0.02 * std::cos(angle)) / 0.06;
            CHECK(motion.at(t, "contact/normal_force")[0] == Approx(upwards / steepness).epsilon(2e-3));
            CHECK(motion.at(t, "contact/force")[1] == Approx(upwards).epsilon(2e-3));
            CHECK(motion.at(t, "shaft/drive")[0] == Approx(0.02 * 40.0 + upwards * lift.slope).epsilon(4e-3));
        }
        CHECK(motion.largest("/histories/contact/gap") < 1e-11);
        CHECK(motion.largest("/ledger/energy_error") < 2e-3);
    }
}

TEST_CASE("The place of a roller on its curve is an arc length", "[analyses][joints][cams]") {
    // Of the disc: its radius times the angle of the point of contact about its centre.
    const Motion motion(disc_deck("gauss-4"));
    for (const double t : {0.1, 0.2, 0.3, 0.4, 0.5}) {
        const double angle = 20.0 * t * t;
        const double x = -0.02 * std::sin(angle), y = lift_of_disc(angle).value + 0.02 * std::cos(angle);
        double around =
            std::atan2(x * std::cos(angle) + y * std::sin(angle), x * std::sin(angle) - y * std::cos(angle));
        if (around < 0.0) around += 2.0 * M_PI;
        CHECK(motion.at(t, "contact/curve_place")[0] == Approx(0.05 * around).margin(1e-9));
    }
}

TEST_CASE("A cam that a moment drives keeps Lagrange's equation", "[analyses][joints][cams]") {
    for (const std::string scheme : {"sdirk-4", "radau-5", "gauss-4"}) {
        INFO(scheme);
        const Motion motion(driven_deck(scheme));
        for (const Driven& expected : driven) {
            CHECK(motion.at(expected.time, "tappet/displacement")[1] ==
                  Approx(expected.displacement).margin(2e-9));
            CHECK(motion.at(expected.time, "tappet/velocity")[1] == Approx(expected.velocity).margin(2e-7));
            CHECK(motion.at(expected.time, "shaft/angle")[0] == Approx(expected.angle).epsilon(1e-7));
            CHECK(motion.at(expected.time, "shaft/angle_rate")[0] == Approx(expected.rate).epsilon(1e-7));
            CHECK(motion.at(expected.time, "contact/normal_force")[0] ==
                  Approx(expected.force).epsilon(1e-4));
        }
        // Moment and weight do the work.
        CHECK(motion.largest("/ledger/energy_error") < 1e-5);
        CHECK(motion.all("/ledger/external_work").back() ==
              Approx(1.5 * driven[2].angle - weight * driven[2].displacement).epsilon(1e-6));
    }
}

TEST_CASE("Schemes have their orders with a cam", "[analyses][joints][cams]") {
    const auto error = [](const std::string& scheme, const std::string& step) {
        const Motion motion(without_newton(driven_deck(scheme), scheme), {"analysis.time_step=" + step});
        return std::abs(motion.at(0.35, "shaft/angle")[0] - driven[1].angle);
    };
    for (const auto& [scheme, order] : {std::pair<std::string, double>{"newmark-simplified", 2.0},
                                        {"newmark-ibrahimbegovic", 2.0},
                                        {"generalized-alpha", 2.0},
                                        {"runge-kutta-4", 4.0},
                                        {"sdirk-4", 4.0},
                                        {"gauss-4", 4.0}}) {
        INFO(scheme);
        const double coarse = error(scheme, "0.005"), fine = error(scheme, "0.0025");
        CHECK(std::log2(coarse / fine) > order - 0.4);
    }
}

TEST_CASE("A run with a cam resumes to the last bit", "[analyses][joints][cams]") {
    for (const std::string& deck : {disc_deck("generalized-alpha"), driven_deck("gauss-4")}) {
        const Motion whole(deck), resumed(deck, {}, 137);
        for (const char* name : {"/histories/tappet/displacement",
                                 "/histories/contact/normal_force",
                                 "/histories/contact/curve_place",
                                 "/histories/shaft/angle"})
            CHECK(whole.all(name) == resumed.all(name));
    }
}

TEST_CASE("A tappet without a spring lifts where its weight cannot hold it", "[analyses][joints][cams]") {
    // The disc at 27 rad/s: its centre falls faster than the tappet.
    std::string deck = replaced(replaced(tappet_on_cam, "HEIGHT", "0.04"), "X_AXIS", "[0, -1, 0]");
    deck = replaced(replaced(deck, "RADIUS", disc), "SHAFT", "move = \"60*t^2\"");
    deck = replaced(replaced(deck, "GUIDE", ""), "LIFTS", "lifts = true");
    const auto pull = [](double t) {
        const Lift lift = lift_of_disc(60.0 * t * t);
        return 0.5 * (lift.bend * 14400.0 * t * t + lift.slope * 120.0) + weight;
    };
    double low = 0.15, high = 0.2288;
    REQUIRE(pull(low) > 0.0);
    REQUIRE(pull(high) < 0.0);
    for (int i = 0; i < 60; ++i) (pull(0.5 * (low + high)) > 0.0 ? low : high) = 0.5 * (low + high);
    const Lift lift = lift_of_disc(60.0 * low * low);
    const double since = 0.24 - low;
    const double flying = lift.value + lift.slope * 120.0 * low * since - 0.5 * 9.81 * since * since;
    REQUIRE(flying > lift_of_disc(60.0 * 0.24 * 0.24).value + 1e-4);
    for (const std::string scheme : {"newmark-simplified",
                                     "newmark-ibrahimbegovic",
                                     "generalized-alpha",
                                     "sdirk-4",
                                     "radau-5",
                                     "gauss-4"}) {
        INFO(scheme);
        const Motion motion(replaced(deck, "SCHEME", scheme));
        CHECK(motion.at(0.1, "tappet/displacement")[1] ==
              Approx(lift_of_disc(0.6).value - 0.04).margin(1e-9));
        CHECK(motion.at(0.24, "tappet/displacement")[1] == Approx(flying - 0.04).margin(2e-4));
        CHECK(motion.at(0.24, "contact/curve_gap")[0] > 0.0);
        CHECK(motion.at(0.24, "contact/normal_force")[0] == 0.0);
        for (const double force : motion.all("/histories/contact/normal_force")) CHECK(force >= -1e-9);
    }
}

TEST_CASE("A tappet rests on a cam in statics", "[analyses][joints][cams]") {
    // On the flank of the disc the moment on the shaft is that of weight and spring.
    std::string deck = replaced(disc_deck("SCHEME"), "move = \"20*t^2\"", "move = \"1.2*t\"");
    deck = deck.substr(0, deck.find("[analysis]")) + "[analysis]\nkind = \"static\"\nsteps = 4\n" +
           deck.substr(deck.find("[[history]]"));
    deck = replaced(deck, "\"displacement\", \"velocity\"", "\"displacement\"");
    deck = replaced(deck, "\"angle\", \"angle_rate\", \"drive\"", "\"angle\", \"drive\"");
    const Motion motion(deck);
    const Lift lift = lift_of_disc(1.2);
    CHECK(motion.at(1.0, "tappet/displacement")[1] == Approx(lift.value - 0.04).epsilon(1e-9));
    const double upwards = weight + 2000.0 * (lift.value - 0.02);
    CHECK(motion.at(1.0, "shaft/drive")[0] == Approx(upwards * lift.slope).epsilon(1e-8));
}

TEST_CASE("A roller on an open curve stays between its ends", "[analyses][joints][cams]") {
    // A bead falls along a wire from its upper end to beyond the lower one.
    const std::string wire = R"deck(gravity = [0, -9.81, 0]
[body.bead]
mass = 1
inertia = [0.1, 0.1, 0.1]
at = [0, 0, 0]
[joint.wire]
type = "cam"
between = ["ground", "bead"]
at_a = [0, 0, 0]
axis = [0, 0, 1]
curve = { points = [[0, 0], [0.2, -0.2], [0.4, -0.4], [0.6, -0.6], [0.8, -0.8], [1, -1]], closed = false }
[analysis]
kind = "dynamic"
end_time = END
time_step = 0.01
[[history]]
name = "wire"
at = "wire"
quantities = ["curve_place", "normal_force"]
)deck";
    const Motion motion(replaced(wire, "END", "0.5"));
    CHECK(motion.at(0.5, "wire/curve_place")[0] == Approx(0.5 * 9.81 * std::sqrt(0.5) * 0.25).epsilon(1e-6));
    CHECK(std::abs(motion.at(0.5, "wire/normal_force")[0]) == Approx(9.81 * std::sqrt(0.5)).epsilon(1e-6));
    const RunSummary summary = run_problem(test::read(replaced(wire, "END", "1")));
    CHECK(summary.status != RunStatus::complete);
    CHECK_THAT(summary.reason, Catch::Contains("joint wire runs off the end of its curve at t = 0.64"));
}
