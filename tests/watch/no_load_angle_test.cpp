#include <cmath>

#include "deck/decks.hpp"
#include "tools/recorded_motion.hpp"

namespace gxrod::test {
namespace {

// A riser that is turned by 0.5 about z at its start, and a fitting that is turned by 0.2.
const std::string deck = R"deck([section.s]
stiffness = { EA = 1e6, GAy = 1e6, GAz = 1e6, GJ = 100, EIy = 100, EIz = 100 }
inertia = { rhoA = 1, rhoIy = 1e-3, rhoIz = 1e-3 }
[rod.riser]
section = "s"
line = { from = [0, 0, 0], to = [2, 0, 0] }
elements = 2
[rod.fitting]
section = "s"
line = { from = [0, 0, 1], to = [0, 1, 1] }
elements = 1
[[support]]
at = "riser.start"
fix = ["position", "rx", "ry"]
move = { rz = "0.5*t" }
[[support]]
at = "fitting.start"
fix = ["position", "rx", "ry"]
move = { rz = "0.2*t" }
[analysis]
kind = "quasi-static"
end_time = 1
time_step = 0.1
[[history]]
name = "fixed"
at = "riser.end"
no_load = [0, 3, 0]
quantities = ["no_load_angle"]
[[history]]
name = "own"
at = "riser.start"
quantities = ["no_load_angle"]
[[history]]
name = "carried"
at = "riser@0.7"
relative_to = "fitting.end"
no_load = [2, 0, 0]
quantities = ["no_load_angle"]
[[history]]
name = "across"
at = "riser.end"
relative_to = "fitting.end"
no_load = [0, 0, 1]
quantities = ["no_load_angle"]
)deck";

}  // namespace

TEST_CASE("The angle to a no-load direction is that of the axis to it, where it is carried", "[watch]") {
    const tools::RecordedMotion motion(deck);
    const double quarter = std::acos(0.0);
    for (const double time : {0.0, 0.4, 1.0}) {
        const auto angle = [&](const std::string& name) {
            return motion.at(time, name + "/no_load_angle")[0];
        };
        CHECK(angle("fixed") == Approx(quarter - 0.5 * time).epsilon(1e-12));
        CHECK(angle("own") == Approx(0.5 * time).margin(1e-12));
        CHECK(angle("carried") == Approx(0.3 * time).margin(1e-12));
        CHECK(angle("across") == Approx(quarter).epsilon(1e-12));
    }
    CHECK_THAT(faults_of(replaced(deck, "no_load = [0, 3, 0]", "no_load = [0, 0, 0]")),
               Catch::Contains("history[0].no_load: expected a direction, found a vector of zero length"));
    CHECK_THAT(
        faults_of(replaced(deck,
                           "no_load = [0, 3, 0]\nquantities = [\"no_load_angle\"]",
                           "no_load = [0, 3, 0]\nquantities = [\"axis_x\"]")),
        Catch::Contains("history[0].no_load: goes with no_load_angle, which is not among the quantities"));
}

}  // namespace gxrod::test
