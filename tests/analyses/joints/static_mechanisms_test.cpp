// Equilibria of mechanisms of rigid bodies, which nothing but their joints holds.

#include <cmath>

#include "tools/problem_run.hpp"
#include "tools/recorded_motion.hpp"

using namespace gxrod;
using namespace gxrod::tools;
using test::replaced;

namespace {

// A crank lifts a piston by a link; lengths are in L, masses in M.
const std::string crank_and_piston = R"deck(gravity = [0, "-9.81*L", 0]
[parameters]
L = LENGTH
M = MASS
[body.crank]
mass = "M"
inertia = ["M*L^2", "M*L^2", "M*L^2"]
at = [0, 0, 0]
[body.piston]
mass = "M"
inertia = ["M*L^2", "M*L^2", "M*L^2"]
at = [0, "4*L", 0]
[joint.shaft]
type = "hinge"
between = ["ground", "crank"]
axis = [0, 0, 1]
move = "1.2*t"
[joint.guide]
type = "slider"
between = ["ground", "piston"]
axis = [0, 1, 0]
SPRING
[joint.link]
type = "distance"
between = ["crank", "piston"]
at_a = ["1*L", "-2*L", 0]
at_b = [0, "4*L", 0]
[analysis]
kind = "static"
steps = 2
[[history]]
name = "piston"
at = "piston"
quantities = ["displacement"]
[[history]]
name = "shaft"
at = "shaft"
quantities = ["drive"]
)deck";

std::string crank_deck(const std::string& length, const std::string& mass, const std::string& spring) {
    return replaced(replaced(replaced(crank_and_piston, "LENGTH", length), "MASS", mass), "SPRING", spring);
}

// The height of the piston by lengths of 1, and its derivative by the angle.
struct Height {
    double value, slope;
};
Height height_of_piston(double angle) {
    const double x = std::cos(angle) + 2.0 * std::sin(angle), y = std::sin(angle) - 2.0 * std::cos(angle);
    const double root = std::sqrt(37.0 - x * x);
    return {y + root, x + x * y / root};
}

}  // namespace

TEST_CASE("A mechanism of bodies stands by its joints alone", "[analyses][joints]") {
    const Height height = height_of_piston(1.2);
    for (const auto& [length, mass] : {std::pair<std::string, std::string>{"0.01", "0.5"},
                                       {"10", "5e-4"},
                                       {"1", "1e6"},
                                       {"1e-5", "1e-9"}}) {
        INFO(length << " " << mass);
        const double L = std::stod(length), M = std::stod(mass);
        const RecordedMotion motion(crank_deck(length, mass, ""));
        CHECK(motion.at(1.0, "piston/displacement")[1] == Approx((height.value - 4.0) * L).epsilon(1e-10));
        CHECK(motion.at(1.0, "shaft/drive")[0] == Approx(M * 9.81 * L * L * height.slope).epsilon(1e-9));
        CHECK(motion.largest("/solver/newton_iterations") <= 8.0);
    }
}

TEST_CASE("A spring of a joint is all that yields in a mechanism", "[analyses][joints]") {
    const Height height = height_of_piston(1.2);
    const RecordedMotion motion(crank_deck("0.01", "0.5", "spring = { stiffness = 2000 }"));
    const double rise = (height.value - 4.0) * 0.01;
    CHECK(motion.at(1.0, "piston/displacement")[1] == Approx(rise).epsilon(1e-10));
    CHECK(motion.at(1.0, "shaft/drive")[0] ==
          Approx((0.5 * 0.0981 + 2000.0 * rise) * 0.01 * height.slope).epsilon(1e-9));
    CHECK(motion.largest("/solver/newton_iterations") <= 8.0);
}
