// Friction that follows the force which a joint holds.

#include <cmath>

#include "tools/recorded_motion.hpp"

using namespace gxrod;
using namespace gxrod::tools;
using test::replaced;

namespace {

using Motion = RecordedMotion;

// A disc on a horizontal pin, its weight across it.
const std::string disc = R"(gravity = [0, -9.81, 0]
[body.disc]
mass = 2
inertia = [0.05, 0.05, 0.05]
at = [0, 0, 0]
angular_velocity = [0, 0, 30]
[joint.pin]
type = "hinge"
between = ["ground", "disc"]
axis = [0, 0, 1]
friction = { coefficient = 0.2, radius = 0.03 }
[analysis]
kind = "dynamic"
end_time = 13
time_step = 0.02
[[history]]
name = "pin"
at = "pin"
quantities = ["angle", "angle_rate", "friction", "force"]
)";

// A block that slides along x while a growing load, 30 t, presses it down.
const std::string block = R"(
[body.block]
mass = 3
inertia = [1, 1, 1]
at = [0, 0, 0]
velocity = [4, 0, 0]
[joint.guide]
type = "TYPE"
between = ["ground", "block"]
axis = [1, 0, 0]
friction = FRICTION
[[load]]
at = "block"
force = [0, "-18*t", "24*t"]
[analysis]
kind = "dynamic"
end_time = 1
time_step = 0.01
[[history]]
name = "guide"
at = "guide"
quantities = ["slide", "slide_rate", "friction"]
)";

}  // namespace

TEST_CASE("A disc on a pin stops by the friction of its weight", "[analyses][joints][friction]") {
    // The moment is 0.2 * 0.03 * 2 * 9.81, the angle 900 / 2 * 0.05 over it.
    constexpr double moment = 0.11772;
    for (const char* scheme : {"newmark-simplified", "generalized-alpha", "sdirk-4"}) {
        INFO(scheme);
        const Motion motion(disc, {std::string("analysis.integrator=\"") + scheme + "\""});
        CHECK(motion.at(5.0, "pin/angle_rate")[0] == Approx(30.0 - 5.0 * moment / 0.05).epsilon(1e-6));
        CHECK(motion.at(5.0, "pin/friction")[0] == Approx(-moment).epsilon(1e-6));
        CHECK(motion.at(13.0, "pin/angle")[0] == Approx(191.131498470948).margin(1e-3));
        CHECK(std::abs(motion.at(13.0, "pin/angle_rate")[0]) < 0.1);
        CHECK(motion.largest("/ledger/dissipated_energy") == Approx(22.5).epsilon(1e-3));
        CHECK(motion.largest("/ledger/energy_error") < 1e-2);
    }
}

TEST_CASE("A block slides against the friction of a growing load", "[analyses][joints][friction]") {
    // v = 4 - 0.2 * 15 t^2 / 3.
    for (const char* type : {"slider", "cylinder"}) {
        const bool is_slider = std::string(type) == "slider";
        const std::string deck = replaced(replaced(block, "TYPE", type),
                                          "FRICTION",
                                          is_slider ? "{ coefficient = 0.2, stick = 1e-5 }"
                                                    : "{ slide = { coefficient = 0.2, stick = 1e-5 } }");
        for (const char* scheme : {"newmark-simplified",
                                   "newmark-ibrahimbegovic",
                                   "generalized-alpha",
                                   "sdirk-4",
                                   "runge-kutta-4"}) {
            INFO(type << ", " << scheme);
            const Motion motion(deck, {std::string("analysis.integrator=\"") + scheme + "\""});
            CHECK(motion.at(1.0, "guide/slide_rate")[0] == Approx(3.0).epsilon(2e-4));
            CHECK(motion.at(1.0, "guide/slide")[0] == Approx(4.0 - 1.0 / 3.0).epsilon(2e-4));
            CHECK(motion.at(1.0, "guide/friction")[0] == Approx(-6.0).epsilon(1e-5));
        }
    }
}
