// Limit points that are followed in a second parameter. Reference values by spectral elements and by
// shooting.
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

// A shallow arch, clamped at both ends and pushed down at its crown.
const std::string arch = R"deck(
plane = "xy"
[section.s]
stiffness = { EA = 1e7, GAy = 4e6, GAz = 4e6, GJ = 1e5, EIy = 1e5, EIz = 1e5 }
[rod.arch]
section = "s"
arc = { centre = [0, 0, 0], axis = [0, 0, 1], from = ["100*sin(0.2)", "100*cos(0.2)", 0], angle = 0.4 }
elements = 16
order = 4
[[support]]
at = "arch.start"
fix = "all"
[[support]]
at = "arch.end"
fix = "all"
[[load]]
at = "arch@0.5"
force = [0, -1, 0]
[[history]]
name = "crown"
at = "arch@0.5"
quantities = ["displacement"]
)deck";

const std::string aside = "[[load]]\nat = \"arch@0.5\"\nforce = [1, 0, 0]\nrelative_to = \"limit\"\n";

const std::string stages = R"(
[[stage]]
name = "load"
kind = "path"
until = { points = 1 }
newton = { tolerance = 1e-11 }
[[stage]]
name = "limits"
kind = "path"
follow = "limit"
until = { t = 0.05 }
at = [{ t = [0.01] }]
newton = { tolerance = 1e-11 }
)";

// Rows of stage 1 where t is this.
double limit_load_at(const Hdf5Reader& file, double t) {
    const std::vector<double> stage = file.numbers("/histories/stage");
    const std::vector<double> parameter = file.numbers("/histories/load_factor");
    const std::vector<double> limit = file.numbers("/histories/limit_load_factor");
    for (std::size_t i = 0; i < stage.size(); ++i) {
        if (stage[i] == 1.0 && std::abs(parameter[i] - t) < 1e-12) return limit[i];
    }
    return std::nan("");
}

}  // namespace

TEST_CASE("A limit load is followed while an imperfection grows", "[analyses][path]") {
    const sample::ScratchFolder folder;
    const Problem problem = read(arch + aside + stages);
    const RunSummary summary = run_problem(problem, folder / "arch.vtkhdf");
    INFO(summary.reason);
    REQUIRE(summary.status == RunStatus::complete);
    const Hdf5Reader file(folder / "arch.vtkhdf");
    CHECK(limit_load_at(file, 0.01) == Approx(703.1159928349).epsilon(1e-8));
    CHECK(limit_load_at(file, 0.05) == Approx(702.9861341710).epsilon(1e-8));
    // Where the load stage ended: the limit of the perfect arch.
    const std::vector<double> stage = file.numbers("/histories/stage");
    const std::vector<double> limit = file.numbers("/histories/limit_load_factor");
    const auto first = std::find(stage.begin(), stage.end(), 1.0) - stage.begin();
    CHECK(limit[static_cast<std::size_t>(first) - 1] == Approx(703.121428357).epsilon(1e-8));
    REQUIRE(summary.findings.size() == 2);
    CHECK(summary.findings[1].find("limit point followed to t = 0.05") != std::string::npos);

    // What follows a limit is itself resumed to the last bit.
    const auto stop = static_cast<int>(first) + 1;
    REQUIRE(run_problem(read(arch + aside + stages), folder / "part.vtkhdf", stop).status ==
            RunStatus::interrupted);
    const Problem anew = read(arch + aside + stages);
    REQUIRE(resume_problem(anew, folder / "part.vtkhdf").status == RunStatus::complete);
    CHECK(Hdf5Reader(folder / "part.vtkhdf").numbers("/histories/limit_load_factor") == limit);
}

TEST_CASE("Limit points in another parameter are those of paths with that parameter", "[analyses][path]") {
    // A load of fixed size sideways, and one along the arch that grows with t: the path with both at its end
    // has the same limit.
    const std::string fixed =
        "[[load]]\nat = \"arch@0.3\"\nforce = [\"20*t\", 0, 0]\nstages = [\"limits\"]\n"
        "[[load]]\non = \"arch\"\nforce_per_length = [0, \"-2*t\", 0]\n"
        "frame = \"follower\"\nstages = [\"limits\"]\n";
    const sample::ScratchFolder folder;
    const std::string to_one = replaced(replaced(stages, "t = 0.05", "t = 1"), "at = [{ t = [0.01] }]\n", "");
    REQUIRE(run_problem(read(arch + fixed + to_one), folder / "arch.vtkhdf").status == RunStatus::complete);
    const double followed = limit_load_at(Hdf5Reader(folder / "arch.vtkhdf"), 1.0);

    const std::string there =
        "[[load]]\nat = \"arch@0.3\"\nforce = [20, 0, 0]\nfactor = \"1\"\n"
        "[[load]]\non = \"arch\"\nforce_per_length = [0, -2, 0]\n"
        "frame = \"follower\"\nfactor = \"1\"\n";
    const std::string path =
        "[analysis]\nkind = \"path\"\nuntil = { points = 1 }\nnewton = { tolerance = 1e-11 }\n";
    REQUIRE(run_problem(read(arch + there + path), folder / "path.vtkhdf").status == RunStatus::complete);
    const Hdf5Reader file(folder / "path.vtkhdf");
    CHECK(file.texts("/stages/path/critical_points/kind")[0] == "limit");
    CHECK(followed == Approx(file.numbers("/stages/path/critical_points/load_factor")[0]).epsilon(1e-9));
}

TEST_CASE("Only limit points are followed", "[analyses][path]") {
    const sample::ScratchFolder folder;
    const std::string early = replaced(stages, "until = { points = 1 }", "until = { t = 300 }");
    const RunSummary summary = run_problem(read(arch + aside + early), folder / "arch.vtkhdf");
    CHECK(summary.status == RunStatus::failed);
    CHECK(summary.reason.find("does not end at a limit point") != std::string::npos);
}
