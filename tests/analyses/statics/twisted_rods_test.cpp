// Rods and rings that are twisted far: loops, with values by shooting and by spectral elements.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "deck/decks.hpp"
#include "results/file/hdf5_reader.hpp"
#include "results/sample.hpp"
#include "tools/catch.hpp"
#include "tools/problem_run.hpp"

using namespace gxrod;
using namespace gxrod::tools;
using test::read;
using test::replaced;

namespace {

// A straight rod, as stiff to all sides; its middle stays in a plane, for it may turn as a whole.
const std::string rod = R"deck(
[section.s]
stiffness = { EA = 1e4, GAy = 4e3, GAz = 4e3, GJ = 0.8, EIy = 1, EIz = 1 }
[rod.rod]
section = "s"
line = { from = [0, 0, 0], to = [1, 0, 0] }
elements = 16
order = 4
[[support]]
at = "rod.start"
fix = "all"
[[support]]
at = "rod@0.5"
fix = ["z"]
)deck";

const std::string histories = R"deck(
[[history]]
name = "end"
at = "rod.end"
quantities = ["displacement", "rotation_vector", "reaction_force", "reaction_moment"]
[[history]]
name = "middle"
at = "rod@0.5"
quantities = ["displacement"]
)deck";

// The difference of two angles, but for whole turns.
double turn_between(double a, double b) { return std::remainder(a - b, 2.0 * std::numbers::pi); }

}  // namespace

TEST_CASE("A twisted rod forms a loop, as its ends come closer", "[analyses][path]") {
    const std::string twist = R"(
[[support]]
at = "rod.end"
fix = ["y", "z", "ry", "rz"]
[[load]]
at = "rod.end"
moment = [1, 0, 0]
[analysis]
kind = "path"
until = { t = [-4, 10], points = 1 }
max_step = 0.1
at = [{ of = "rod.end", displacement = "x", values = [-0.05, -0.2, -0.4, -0.8] }]
branches = 1
newton = { tolerance = 1e-11 }
)";
    const sample::ScratchFolder folder;
    const std::string all =
        replaced(rod + twist + histories, ", \"reaction_force\", \"reaction_moment\"", "");
    REQUIRE(run_problem(read(all), folder / "rod.vtkhdf").status == RunStatus::complete);
    const Hdf5Reader file(folder / "rod.vtkhdf");
    CHECK(file.numbers("/stages/path/critical_points/load_factor")[0] ==
          Approx(8.977850088768).epsilon(1e-8));
    const std::vector<double> couple = file.numbers("/histories/load_factor");
    const std::vector<double> moved = file.numbers("/histories/end/displacement");
    const std::vector<double> turned = file.numbers("/histories/end/rotation_vector");
    const std::vector<double> middle = file.numbers("/histories/middle/displacement");
    const std::vector<double> pivots = file.numbers("/solver/negative_pivots");
    // End shortening, couple, turn, and how far the middle is from the line.
    const double expected[][4] = {{0.05, 8.5475257668, 11.0230613023, 0.1044474833},
                                  {0.2, 7.1136135551, 10.2711661968, 0.1966244702},
                                  {0.4, 4.6305928599, 8.6148680867, 0.2567158855},
                                  {0.8, -3.4700130508, 1.3202548480, 0.3194168796}};
    for (const auto& [shortening, M, turn, y] : expected) {
        INFO(shortening);
        int found = 0;
        for (std::size_t row = 0; row < couple.size(); ++row) {
            if (std::abs(moved[3 * row] + shortening) > 1e-9) continue;
            ++found;
            CHECK(couple[row] == Approx(M).epsilon(1e-8));
            CHECK(std::abs(turn_between(turned[3 * row], turn)) < 1e-8);
            CHECK(std::abs(middle[3 * row + 1]) == Approx(y).epsilon(1e-8));
            CHECK(pivots[row] == 1.0);
        }
        CHECK(found == 2);
    }
}

TEST_CASE("A slack rod is twisted out of its plane", "[analyses]") {
    // Planar first: a load in the middle that goes again says to which side.
    const std::string stages = R"deck(
[[support]]
at = "rod.end"
fix = ["y", "z", "rx", "ry", "rz"]
move = { x = -0.3 }
stages = ["slacken"]
[[support]]
at = "rod.end"
fix = ["y", "z", "ry", "rz"]
move = { x = -0.3, rx = "10*t" }
stages = ["twist"]
[[load]]
at = "rod@0.5"
force = [0, 20, 0]
factor = { slacken = "4*t*(1-t)" }
[[stage]]
name = "slacken"
kind = "static"
steps = 20
newton = { tolerance = 1e-11 }
[[stage]]
name = "twist"
kind = "static"
steps = 20
newton = { tolerance = 1e-11 }
)deck";
    const sample::ScratchFolder folder;
    REQUIRE(run_problem(read(rod + stages + histories), folder / "rod.vtkhdf").status == RunStatus::complete);
    const Hdf5Reader file(folder / "rod.vtkhdf");
    const std::vector<double> stage = file.numbers("/histories/stage");
    const std::vector<double> force = file.numbers("/histories/end/reaction_force");
    const std::vector<double> moment = file.numbers("/histories/end/reaction_moment");
    const auto twist = static_cast<std::size_t>(std::find(stage.begin(), stage.end(), 1.0) - stage.begin());
    CHECK(force[3 * (twist - 1)] == Approx(-46.2039270).epsilon(2e-9));
    CHECK(file.numbers("/histories/middle/displacement")[3 * (twist - 1) + 1] ==
          Approx(0.3124911499).epsilon(1e-9));
    // Turn, couple and axial force.
    const double expected[][3] = {{1, 0.3377874325, -44.7772756519},
                                  {2, 0.7970722331, -41.3271760085},
                                  {4, 2.0010467847, -31.9744244217},
                                  {6, 3.3796055554, -21.2336619270},
                                  {10, 6.2986598385, 2.7083154267}};
    for (const auto& [turn, M, T] : expected) {
        INFO(turn);
        const std::size_t row = twist - 1 + static_cast<std::size_t>(2.0 * turn);
        REQUIRE(row < stage.size());
        CHECK(moment[3 * row] == Approx(M).epsilon(1e-8));
        CHECK(force[3 * row] == Approx(T).epsilon(1e-8));
    }
}

TEST_CASE("A path follows a support that turns a ring into three loops", "[analyses][path]") {
    const std::string ring = R"(
[section.s]
stiffness = { EA = 1e4, GAy = 1e4, GAz = 1e4, GJ = 1.5, EIy = 1, EIz = 4 }
[rod.right]
section = "s"
arc = { centre = [1, 0, 0], axis = [0, 0, 1], from = [0, 0, 0], angle = "pi" }
y_axis = [0, 0, 1]
elements = 10
order = 4
[rod.left]
section = "s"
arc = { centre = [1, 0, 0], axis = [0, 0, 1], from = [0, 0, 0], angle = "-pi" }
y_axis = [0, 0, 1]
elements = 10
order = 4
[[connect]]
points = ["right.start", "left.start"]
[[connect]]
points = ["right.end", "left.end"]
[[support]]
at = "right.start"
fix = "all"
[[support]]
at = "right.end"
fix = ["y", "z", "ry", "rz"]
move = { rx = "pi*t" }
[[history]]
name = "end"
at = "right.end"
quantities = ["displacement", "reaction_moment"]
[analysis]
kind = "path"
until = { t = 2 }
at = [{ t = [0.25, 0.5, 1, 1.25, 1.5, 1.75] }]
)";
    const sample::ScratchFolder folder;
    const RunSummary summary = run_problem(read(ring), folder / "ring.vtkhdf");
    REQUIRE(summary.status == RunStatus::complete);
    CHECK(summary.totals.steps < 200);
    CHECK(summary.findings.empty());  // stable as long as the turn is held
    const Hdf5Reader file(folder / "ring.vtkhdf");
    const std::vector<double> half_turns = file.numbers("/histories/load_factor");
    const std::vector<double> couple = file.numbers("/histories/end/reaction_moment");
    const std::vector<double> moved = file.numbers("/histories/end/displacement");
    const double expected[][3] = {{0.25, 2.4015431991, 2.0360627865},
                                  {0.5, 3.5692661166, 2.1197430479},
                                  {1, 3.2921718506, 2.1349571638},
                                  {1.25, 2.7295498151, 1.7736893378},
                                  {1.5, 0.4201038618, 0.8958574159},
                                  {1.75, -0.0189390467, 0.7116989142},
                                  {2, 0, 2.0 / 3.0}};
    for (const auto& [turn, M, x] : expected) {
        INFO(turn);
        const auto at = std::find_if(half_turns.begin(), half_turns.end(), [t = turn](double found) {
            return std::abs(found - t) < 1e-12;
        });
        REQUIRE(at != half_turns.end());
        const auto row = static_cast<std::size_t>(at - half_turns.begin());
        CHECK(std::abs(couple[3 * row] - M) < 2e-7);
        CHECK(std::abs(2.0 + moved[3 * row] - x) < 2e-7);
    }
}
