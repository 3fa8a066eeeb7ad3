// Paths whose steps prescribe a displacement or a rotation, and paths of models with a continuous symmetry.
#include <cmath>

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

// Lee's frame: the load at a fifth of the beam turns back, and later its displacement does.
const std::string frame = R"deck(
plane = "xy"
[section.s]
stiffness = { EA = 4320, GAy = "18000/13", GAz = "18000/13", GJ = 1440, EIy = 1440, EIz = 1440 }
[rod.leg]
section = "s"
line = { from = [0, 0, 0], to = [0, 120, 0] }
elements = 5
order = 4
[rod.beam]
section = "s"
line = { from = [0, 120, 0], to = [120, 120, 0] }
elements = 5
order = 4
[[connect]]
points = ["leg.end", "beam.start"]
[[support]]
at = "leg.start"
fix = ["x", "y"]
[[support]]
at = "beam.end"
fix = ["x", "y"]
[[load]]
at = "beam@0.2"
force = [0, -1, 0]
[[history]]
name = "loaded"
at = "beam@0.2"
quantities = ["displacement"]
)deck";

std::string path(const std::string& control) {
    return "[analysis]\nkind = \"path\"\nuntil = { t = 6, steps = 200 }\nnewton = { tolerance = 1e-11 }\n"
           "control = { of = \"beam@0.2\", " +
           control + " }\n";
}

}  // namespace

TEST_CASE("A path under displacement control goes over limit loads to its end", "[analyses][path]") {
    const sample::ScratchFolder folder;
    const Problem problem = read(frame + path("displacement = \"y\", to = -60"));
    const RunSummary summary = run_problem(problem, folder / "lee.vtkhdf");
    INFO(summary.reason);
    REQUIRE(summary.status == RunStatus::complete);
    const Hdf5Reader file(folder / "lee.vtkhdf");
    const std::vector<double> load = file.numbers("/histories/load_factor");
    const std::vector<double> moved = file.numbers("/histories/loaded/displacement");
    CHECK(moved[3 * (load.size() - 1) + 1] == Approx(-60.0).epsilon(1e-12));
    CHECK(load.back() == Approx(1.483172755040).epsilon(1e-7));
    CHECK(file.numbers("/stages/path/critical_points/load_factor").at(0) ==
          Approx(1.854452709444).epsilon(1e-7));
    for (std::size_t i = 1; i < load.size(); ++i) CHECK(moved[3 * i + 1] < moved[3 * i - 2]);
    // Upwards the load falls.
    const Problem upwards = read(frame + path("displacement = \"y\", to = 3"));
    REQUIRE(run_problem(upwards, folder / "up.vtkhdf").status == RunStatus::complete);
    CHECK(Hdf5Reader(folder / "up.vtkhdf").numbers("/histories/load_factor").back() < -0.1);
}

TEST_CASE("Displacement control fails where the displacement turns back, and says so", "[analyses][path]") {
    const sample::ScratchFolder folder;
    const RunSummary summary = run_problem(read(frame + path("displacement = \"y\"")), folder / "lee.vtkhdf");
    CHECK(summary.status == RunStatus::failed);
    CHECK(summary.reason.find("the displacement or rotation that controls the path turns back here") !=
          std::string::npos);
    const Hdf5Reader file(folder / "lee.vtkhdf");
    const std::vector<double> moved = file.numbers("/histories/loaded/displacement");
    CHECK(moved[moved.size() - 2] == Approx(-61.01553304).epsilon(1e-4));
}

TEST_CASE("A rotation can control a path", "[analyses][path]") {
    const sample::ScratchFolder folder;
    const std::string control =
        replaced(path("rotation = \"z\""), "until = { t = 6,", "until = { points = 1,");
    REQUIRE(run_problem(read(frame + control), folder / "lee.vtkhdf").status == RunStatus::complete);
    CHECK(Hdf5Reader(folder / "lee.vtkhdf").numbers("/stages/path/critical_points/load_factor").at(0) ==
          Approx(1.854452709444).epsilon(1e-7));
}

namespace {

// A slack rod, as stiff to all sides, that a passing load sets in a bow; then an end turns.
const std::string bow = R"deck(
[section.s]
stiffness = { EA = 1e3, GAy = 4e2, GAz = 4e2, GJ = 0.8, EIy = 1, EIz = 1 }
[rod.bow]
section = "s"
line = { from = [0, 0, 0], to = [1, 0, 0] }
elements = 6
order = 3
[[support]]
at = "bow.start"
fix = "all"
[[support]]
at = "bow.end"
fix = ["y", "z", "rx", "ry", "rz"]
move = { x = -0.3 }
stages = ["bow"]
[[support]]
at = "bow.end"
fix = ["y", "z", "ry", "rz"]
move = { x = -0.3, rx = "t" }
stages = ["turn"]
[[load]]
at = "bow@0.5"
force = [0, 10, 0]
factor = { bow = "4*t*(1-t)" }
[[stage]]
name = "bow"
kind = "static"
steps = 20
[[stage]]
name = "turn"
kind = "path"
until = { t = 0.5 }
)deck";

}  // namespace

TEST_CASE("A continuous symmetry is reported with what to hold", "[analyses][path]") {
    const sample::ScratchFolder folder;
    const RunSummary summary = run_problem(read(bow), folder / "bow.vtkhdf");
    INFO(summary.reason);
    CHECK(summary.status == RunStatus::failed);
    CHECK(summary.reason.find("the model has a continuous symmetry") != std::string::npos);
    CHECK(summary.reason.find("Hold one displacement against it, such as that of bow@0.5 (z)") !=
          std::string::npos);

    const Problem held = read(bow + "[[support]]\nat = \"bow@0.5\"\nfix = [\"z\"]\n");
    const RunSummary other = run_problem(held, folder / "held.vtkhdf");
    REQUIRE(other.status == RunStatus::complete);
    CHECK(other.findings.empty());
}
