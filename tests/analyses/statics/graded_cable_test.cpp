// A hung cable whose ends are clamped level: moments there have boundary layers of √(EI/T), a hundredth of
// it. Values by collocation and by multiple shooting, to 1e-8.
#include <cmath>

#include "deck/decks.hpp"
#include "tools/static_run.hpp"

namespace gxrod::test {
namespace {

// The ends are turned to level from the slopes −V/H of a catenary that does not stretch, as it has a rest.
const std::string cable = R"deck(
gravity = [0, 0, -9.81]
plane = "xz"
[section.s]
stiffness = { EA = 1e6, GAy = 4e5, GAz = 4e5, GJ = 2e4, EIy = 2e4, EIz = 2e4 }
inertia = { rhoA = 20, rhoIy = 0.0125, rhoIz = 0.0125 }
[rod.cable]
section = "s"
catenary = { from = [0, 0, 0], to = [100, 0, 20], length = 120 }
rest = { line = { from = [0, 0, 0], to = [120, 0, 0] } }
elements = 16
order = 4
[[support]]
at = "cable.start"
fix = ["position", "rx", "rz"]
move = { ry = "-atan(9225.53699635976/9603.43917624285)" }
[[support]]
at = "cable.end"
fix = ["position", "rx", "rz"]
move = { ry = "atan(14318.4630036402/9603.43917624285)" }
[analysis]
kind = "static"
steps = 10
)deck";

// The larger relative error of the moments at the ends.
double error_of(const std::vector<std::string>& overrides) {
    const Problem problem = read(cable, overrides);
    const tools::StaticRun run =
        tools::run_static(problem.model, std::get<StaticSettings>(problem.analysis()));
    const auto error = [](double moment, double is) { return std::abs(std::abs(moment) / is - 1.0); };
    return std::max(error(run.reactions.front()[4], 12394.578726126),
                    error(run.reactions.back()[4], 17461.472875684));
}

}  // namespace

TEST_CASE("Graded elements resolve the boundary layers of a clamped cable", "[analyses]") {
    const std::string spacing = "rod.cable.spacing=[[0, 0.05], [0.2, 1], [0.8, 1], [1, 0.05]]";
    CHECK(error_of({}) > 5e-3);
    CHECK(error_of({spacing}) < 1e-6);
    CHECK(error_of({spacing, "rod.cable.elements=32"}) < 3e-9);
    // With order 2 the moment's error falls by 2⁴ as the elements are halved.
    const double coarse = error_of({spacing, "rod.cable.order=2", "rod.cable.elements=32"});
    const double fine = error_of({spacing, "rod.cable.order=2", "rod.cable.elements=64"});
    CHECK(std::log2(coarse / fine) == Approx(4.0).margin(0.15));
}

}  // namespace gxrod::test
