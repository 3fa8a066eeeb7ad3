// Paths as decks run them: rows, tables, branches, and what later stages and resumed runs find.
#include <algorithm>

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

// A deep arch on two hinges, pushed down at its crown: it sways from P = 327.63 on (reference values by
// spectral elements and by shooting).
const std::string arch = R"deck(
[parameters]
half = "215*pi/360"
x = "100*sin(half)"
y = "100*cos(half)"
[section.s]
stiffness = { EA = 1e8, GAy = 1e8, GAz = 1e8, GJ = 1e9, EIy = 1e6, EIz = 1e9 }
[rod.arch]
section = "s"
arc = { centre = [0, 0, 0], axis = [0, 0, 1], from = ["x", "y", 0], angle = "2*half" }
elements = 16
order = 3
[[support]]
at = "arch.start"
fix = ["x", "y", "z", "rx", "ry"]
[[support]]
at = "arch.end"
fix = ["x", "y", "z", "rx", "ry"]
[[load]]
at = "arch@0.5"
force = [0, -1, 0]
[[history]]
name = "crown"
at = "arch@0.5"
quantities = ["displacement"]
)deck";

const std::string sway = R"(kind = "path"
until = { t = [0, 950], points = 2, steps = 60 }
max_step = 0.05
branches = 1
newton = { tolerance = 1e-11 }
)";

// What both files hold, to the last bit, but for the state to resume from.
void check_equal(const Hdf5Reader& whole, const Hdf5Reader& part) {
    for (const std::string& name : whole.datasets()) {
        if (name.starts_with("/restart") || name.starts_with("/deck") || name.starts_with("/rods/")) continue;
        INFO(name);
        if (name.ends_with("/words") || name.ends_with("/finding") || name.ends_with("/kind") ||
            name.ends_with("/branching") || name.ends_with("/name") || name.ends_with("/cause"))
            continue;  // texts
        CHECK(whole.numbers(name) == part.numbers(name));
    }
}

}  // namespace

TEST_CASE("A path follows the branches that leave it, as rows of the same stage", "[analyses][path]") {
    const sample::ScratchFolder folder;
    const Problem problem = read(
        replaced(arch, "elements = 16", "elements = 32") + "[analysis]\n" +
        replaced(sway,
                 "branches",
                 "at = [{ of = \"arch@0.5\", displacement = \"y\", values = [-20, -40, -80] }]\nbranches"));
    const RunSummary summary = run_problem(problem, folder / "arch.vtkhdf");
    REQUIRE(summary.status == RunStatus::complete);
    const Hdf5Reader file(folder / "arch.vtkhdf");
    const std::vector<double> load = file.numbers("/histories/load_factor");
    const std::vector<double> branch = file.numbers("/histories/branch");
    const std::vector<double> crown = file.numbers("/histories/crown/displacement");
    const std::vector<double> axis = file.numbers("/histories/time");
    REQUIRE(load.size() == branch.size());
    CHECK(std::is_sorted(axis.begin(), axis.end()));
    // P at values of v, on the main path and on both branches.
    const auto check = [&](double number, double v, double P, double u) {
        INFO("branch " << number << ", v = " << v);
        bool is_found = false;
        for (std::size_t row = 0; row < load.size(); ++row) {
            if (branch[row] != number || std::abs(crown[3 * row + 1] + v) > 1e-9) continue;
            is_found = is_found ||
                       (std::abs(load[row] - P) < 2e-6 * P && std::abs(std::abs(crown[3 * row]) - u) < 1e-4);
        }
        CHECK(is_found);
    };
    check(0, 20, 373.057419992, 0);
    check(0, 40, 585.266924585, 0);
    for (const double number : {1.0, 2.0}) {
        check(number, 20, 331.860966168, 22.550968043);
        check(number, 40, 358.853666185, 56.542023390);
        check(number, 80, 408.882676423, 82.228241465);
    }
    const std::string points = "/stages/path/critical_points/", branches = "/stages/path/branches/";
    const std::vector<double> at = file.numbers(points + "load_factor");
    REQUIRE(at.size() >= 4);
    CHECK(at[0] == Approx(327.6277845).epsilon(1e-6));
    CHECK(at[1] == Approx(946.3035197).epsilon(1e-6));
    CHECK(file.numbers(points + "pivots_after")[0] == 1.0);
    const auto row = static_cast<std::size_t>(file.numbers(points + "row")[0]);
    CHECK(load.at(row) == at[0]);
    CHECK(file.texts(points + "kind")[0] == "bifurcation");
    CHECK(file.texts(branches + "name") == std::vector<std::string>{"path", "path.1+", "path.1−"});
    CHECK(file.numbers(branches + "parent") == std::vector<double>{-1, 0, 0});
    CHECK(file.numbers(branches + "critical_point") == std::vector<double>{-1, 0, 0});
    CHECK(file.numbers(branches + "side") == std::vector<double>{0, 1, -1});
    for (std::size_t i = 0; i < 3; ++i) {
        const auto first = static_cast<std::size_t>(file.numbers(branches + "first_row")[i]);
        CHECK(branch.at(first) == static_cast<double>(i));
        CHECK((first == 0 || branch[first - 1] != branch[first]));
    }
    REQUIRE(summary.findings.size() == at.size());
    CHECK(summary.findings[0].starts_with("path: bifurcation at λ = 327.627"));
    const Hdf5Reader shapes(folder / "arch.path.vtkhdf");
    const std::vector<double> places = shapes.numbers("/VTKHDF/Points");
    CHECK(places.size() == 3 * problem.model.nodes.size() * at.size());
    CHECK(shapes.numbers("/VTKHDF/Steps/PointOffsets")[1] == static_cast<double>(problem.model.nodes.size()));
}

TEST_CASE("A path that was stopped on it, or on a branch, goes on to the last bit", "[analyses][path]") {
    const sample::ScratchFolder folder;
    const Problem problem = read(arch + "[analysis]\n" + sway);
    REQUIRE(run_problem(problem, folder / "whole.vtkhdf").status == RunStatus::complete);
    const Hdf5Reader whole(folder / "whole.vtkhdf");
    const std::vector<double> first_rows = whole.numbers("/stages/path/branches/first_row");
    const auto bifurcation = static_cast<int>(whole.numbers("/stages/path/critical_points/row")[0]);
    const std::vector<int> stops{1,
                                 bifurcation - 1,
                                 bifurcation,
                                 bifurcation + 3,
                                 static_cast<int>(first_rows[1]) + 2,
                                 static_cast<int>(first_rows[2]) + 2};
    for (const int stop : stops) {
        INFO(stop);
        REQUIRE(run_problem(problem, folder / "part.vtkhdf", stop).status == RunStatus::interrupted);
        REQUIRE(resume_problem(problem, folder / "part.vtkhdf").status == RunStatus::complete);
        check_equal(whole, Hdf5Reader(folder / "part.vtkhdf"));
        std::filesystem::remove(folder / "part.vtkhdf");
        std::filesystem::remove(folder / "part.path.vtkhdf");
    }
}

TEST_CASE("Loads stay as they were where a path ended, also when the next stage is resumed",
          "[analyses][path]") {
    const sample::ScratchFolder folder;
    const std::string stages = "[[stage]]\nname = \"sway\"\n" + replaced(sway, "points = 2", "points = 1") +
                               "[[stage]]\nname = \"rest\"\nkind = \"static\"\nsteps = 4\n";
    const Problem problem = read(arch + stages);
    REQUIRE(run_problem(problem, folder / "whole.vtkhdf").status == RunStatus::complete);
    const Hdf5Reader whole(folder / "whole.vtkhdf");
    const std::vector<double> load = whole.numbers("/histories/load_factor");
    const std::vector<double> stage = whole.numbers("/histories/stage");
    const std::vector<double> branch = whole.numbers("/histories/branch");
    const std::vector<double> crown = whole.numbers("/histories/crown/displacement");
    std::size_t end = 0;  // of the main path
    while (stage[end + 1] == 0.0 && branch[end + 1] == 0.0) ++end;
    CHECK(load[end] == Approx(327.6277845).epsilon(1e-6));
    CHECK(stage.back() == 1.0);
    CHECK(std::abs(crown[crown.size() - 2] - crown[3 * end + 1]) < 1e-6);
    CHECK(*problem.stages[0].end == load[end]);

    const auto rows = static_cast<int>(load.size());
    REQUIRE(run_problem(read(arch + stages), folder / "part.vtkhdf", rows - 3).status ==
            RunStatus::interrupted);
    const Problem anew = read(arch + stages);
    REQUIRE(*anew.stages[0].end != load[end]);
    REQUIRE(resume_problem(anew, folder / "part.vtkhdf").status == RunStatus::complete);
    check_equal(whole, Hdf5Reader(folder / "part.vtkhdf"));
}

TEST_CASE("A branch that leads from one bifurcation to another is followed once", "[analyses][path]") {
    // A shallow arch, clamped: between its load folds the path is crossed twice by one that leads from the
    // one crossing to the other.
    const sample::ScratchFolder folder;
    const std::string shallow =
        replaced(replaced(replaced(replaced(arch, "elements = 16", "elements = 32"), "215*pi/360", "0.2"),
                          "EIy = 1e6",
                          "EIy = 1e5"),
                 "EA = 1e8, GAy = 1e8, GAz = 1e8",
                 "EA = 1e7, GAy = 4e6, GAz = 4e6");
    const std::string clamped = replaced(replaced(shallow,
                                                  "fix = [\"x\", \"y\", \"z\", \"rx\", \"ry\"]\n[[support]]",
                                                  "fix = \"all\"\n[[support]]"),
                                         "fix = [\"x\", \"y\", \"z\", \"rx\", \"ry\"]\n[[load]]",
                                         "fix = \"all\"\n[[load]]");
    const Problem problem = read(clamped + "[analysis]\nkind = \"path\"\nuntil = { points = 4, arc = 2 }\n" +
                                 "branches = 2\nmax_step = 0.001\n");
    const RunSummary summary = run_problem(problem, folder / "arch.vtkhdf");
    REQUIRE(summary.status == RunStatus::complete);
    const Hdf5Reader file(folder / "arch.vtkhdf");
    const std::vector<double> at = file.numbers("/stages/path/critical_points/load_factor");
    REQUIRE(at.size() >= 4);
    CHECK(at[1] == Approx(527.0679957).epsilon(1e-5));
    CHECK(at[2] == Approx(480.3392595).epsilon(1e-5));
    CHECK(file.texts("/stages/path/branches/name") == std::vector<std::string>{"path", "path.2+"});
}
