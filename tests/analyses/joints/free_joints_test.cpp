// Joints that leave all six motions free, and hold, drive or spring one of them.

#include <cmath>

#include "tools/recorded_motion.hpp"

using namespace gxrod;
using namespace gxrod::tools;
using test::replaced;

namespace {

using Motion = RecordedMotion;

constexpr double GJ = 140.0, EI = 170.0, length = 2.0;

// A shaft on two balls, turned about its axis at both ends by joints that leave the bending rotations free.
const std::string shaft = R"(
[section.s]
stiffness = { EA = 2e5, GAy = 8e4, GAz = 8e4, GJ = 140, EIy = 170, EIz = 170 }
inertia = { rhoA = 1e-4, rhoJ = 2e-9, rhoIy = 1e-9, rhoIz = 1e-9 }
[rod.shaft]
section = "s"
line = { from = [0, 0, 0], to = [2, 0, 0] }
elements = 4
order = 3
[[support]]
at = "shaft.start"
fix = "position"
[[support]]
at = "shaft.end"
fix = ["y", "z"]
[joint.near]
type = "free"
between = ["ground", "shaft.start"]
axis = [1, 0, 0]
move = { turn = "0" }
[joint.far]
type = "free"
between = ["ground", "shaft.end"]
axis = [3, 0, 0]
move = { turn = "0.5*t" }
[[history]]
name = "far"
at = "far"
quantities = ["angle", "drive", "gap", "slide"]
[[history]]
name = "near"
at = "near"
quantities = ["drive"]
[[history]]
name = "middle"
at = "shaft@0.5"
quantities = ["rotation_vector"]
[[history]]
name = "end"
at = "shaft.end"
quantities = ["quaternion"]
)";

// The third component of the section's first axis, from the quaternion w x y z of its rotation.
double rise(const Motion::Row& q) { return 2.0 * (q[1] * q[3] - q[0] * q[2]); }

}  // namespace

TEST_CASE("A shaft is turned about its axis while it bends freely", "[analyses][joints]") {
    const Motion motion(shaft + "[analysis]\nkind = \"static\"\nsteps = 2\n");
    CHECK(motion.at(1.0, "far/angle")[0] == Approx(0.5).epsilon(1e-12));
    CHECK(motion.at(1.0, "far/drive")[0] == Approx(GJ * 0.5 / length).epsilon(1e-8));
    CHECK(motion.at(1.0, "near/drive")[0] == Approx(-GJ * 0.5 / length).epsilon(1e-8));
    CHECK(motion.at(1.0, "middle/rotation_vector")[0] == Approx(0.25).epsilon(1e-8));
    CHECK(motion.largest("/histories/far/gap") < 1e-12 * length);
    CHECK(motion.largest("/ledger/energy_error") < 1e-6);
    // Not turned, and with a load in its middle: as a simply supported beam.
    constexpr double P = 1e-3;
    const Motion bent(replaced(shaft, "\"0.5*t\"", "\"0\"") +
                      "[[load]]\nat = \"shaft@0.5\"\nforce = [0, 0, \"-1e-3*t\"]\n"
                      "[analysis]\nkind = \"static\"\nsteps = 2\n");
    CHECK(rise(bent.at(1.0, "end/quaternion")) == Approx(P * length * length / (16.0 * EI)).epsilon(1e-6));
}

TEST_CASE("A disc follows a shaft that is turned at its end", "[analyses][joints]") {
    // J a'' = k (f - a), f = 2 t^2, k = GJ/L: the far end is driven, the near one carries the disc.
    constexpr double J = 5.0, c = 4.0;
    const double omega = std::sqrt(GJ / length / J);
    std::string deck = replaced(
        shaft,
        "[joint.near]\ntype = \"free\"\nbetween = [\"ground\", \"shaft.start\"]\naxis = [1, 0, 0]\nmove = "
        "{ turn = \"0\" }\n",
        "[body.disc]\nat = \"shaft.start\"\nmass = 1\ninertia = [5, 3, 3]\n");
    deck = replaced(deck, "\"0.5*t\"", "\"2*t^2\"");
    deck = replaced(deck,
                    "name = \"near\"\nat = \"near\"\nquantities = [\"drive\"]",
                    "name = \"disc\"\nat = \"disc\"\nquantities = [\"rotation_vector\"]");
    deck += "[analysis]\nkind = \"dynamic\"\nend_time = 1\ntime_step = 0.01\n";
    for (const char* scheme : {"newmark-simplified", "generalized-alpha", "sdirk-4"}) {
        INFO(scheme);
        const Motion motion(deck, {std::string("analysis.integrator=\"") + scheme + "\""});
        const double angle = 0.5 * c - c / (omega * omega) * (1.0 - std::cos(omega));
        const double moment = J * c * (1.0 - std::cos(omega));
        CHECK(motion.at(1.0, "disc/rotation_vector")[0] == Approx(angle).epsilon(1e-3));
        CHECK(motion.at(1.0, "far/drive")[0] == Approx(moment).epsilon(1e-3));
        CHECK(motion.at(1.0, "far/angle")[0] == Approx(2.0).margin(1e-12));
    }
}

TEST_CASE("A free joint carries springs of its turn and its slide", "[analyses][joints]") {
    // A clamped rod, twisted and pulled: its stiffness and those of the springs add.
    std::string deck = replaced(shaft, "fix = \"position\"", "fix = \"all\"");
    deck = replaced(deck, "[[support]]\nat = \"shaft.end\"\nfix = [\"y\", \"z\"]\n", "");
    deck = replaced(
        deck,
        "[joint.near]\ntype = \"free\"\nbetween = [\"ground\", \"shaft.start\"]\naxis = [1, 0, 0]\nmove = "
        "{ turn = \"0\" }\n",
        "");
    deck = replaced(deck, "[[history]]\nname = \"near\"\nat = \"near\"\nquantities = [\"drive\"]\n", "");
    deck = replaced(deck, "\"drive\", ", "");
    deck = replaced(deck,
                    "move = { turn = \"0.5*t\" }",
                    "spring = { turn = { stiffness = 30 }, slide = { stiffness = 5e4 } }\n"
                    "drive = { turn = \"20*t\", slide = \"150*t\" }");
    const Motion motion(deck + "[analysis]\nkind = \"static\"\nsteps = 2\n");
    CHECK(motion.at(1.0, "far/angle")[0] == Approx(20.0 / (70.0 + 30.0)).epsilon(1e-9));
    CHECK(motion.at(1.0, "far/slide")[0] == Approx(150.0 / (1e5 + 5e4)).epsilon(1e-9));
}
