// Statics along paths of equilibria are silent, however slack the structure is at first; jumps are reported
// with their load factors.

#include "deck/decks.hpp"
#include "model/energy_round_off.hpp"
#include "run/run.hpp"
#include "study/motion_trace.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

const std::string chain = R"deck(gravity = [0, 0, -9.81]
[section.s]
stiffness = { EA = 1e8, GAy = 1e7, GAz = 1e7, GJ = 10, EIy = 10, EIz = 10 }
inertia = { rhoA = 100.0, rhoIy = 1.0, rhoIz = 1.0 }
[rod.c]
section = "s"
polyline = [[0, 0, 0], [30, 0, -40], [80, 0, 0]]
elements = 40
[[support]]
at = "c.start"
fix = ["position", "rx", "rz"]
[[support]]
at = "c.end"
fix = ["position"]
[analysis]
kind = "static"
steps = 10
)deck";

const std::string riser = R"deck(gravity = [0, 0, -7.0]
[section.s]
stiffness = { EA = 4e9, GAy = 1e9, GAz = 1e9, GJ = 1e8, EIy = 1.2e8, EIz = 1.2e8 }
inertia = { rhoA = 200.0, rhoIy = 6.0, rhoIz = 6.0 }
[rod.r]
section = "s"
line = { from = [0, 0, 0], to = [0, 0, 1000] }
elements = 50
[[support]]
at = "r.start"
fix = ["position", "rx", "rz"]
[[support]]
at = "r.end"
fix = ["y"]
move = { x = "100*t" }
[[load]]
at = "r.end"
force = [0, 0, 3e6]
[[load]]
on = "r"
force_per_length = ["100*s/1000", 0, 0]
[analysis]
kind = "static"
steps = 5
)deck";

const std::string column = R"deck([parameters]
P = "0.98*pi^2*500/(4*10^2)"
[section.s]
stiffness = { EA = 1e6, GAy = 5e5, GAz = 5e5, GJ = 400, EIy = 4000, EIz = 500 }
[rod.b]
section = "s"
line = { from = [0, 0, 0], to = [10, 0, 0] }
y_axis = [0, 1, 0]
elements = 20
order = 2
[[support]]
at = "b.start"
fix = "all"
[[load]]
at = "b.end"
force = ["-P", "1e-3*P", 0]
[analysis]
kind = "static"
steps = 10
)deck";

// Its crown is pushed down until it snaps through.
const std::string arch = R"deck([section.s]
stiffness = { EA = 1e5, GAy = 1e5, GAz = 1e5, GJ = 10, EIy = 10, EIz = 10 }
[rod.arch]
section = "s"
arc = { from = [0, 0, 0], through = [5, 0, 0.5], to = [10, 0, 0] }
elements = 20
[[support]]
at = "arch.start"
fix = ["position", "rx", "rz"]
[[support]]
at = "arch.end"
fix = ["position", "rx", "rz"]
[[load]]
at = "arch@0.5"
force = [0, 0, -20]
[analysis]
kind = "static"
steps = 20
)deck";

// Two bars in a shallow roof, an arch without bending.
const std::string roof = R"deck([section.s]
stiffness = { EA = 1e4, GAy = 1e4, GAz = 1e4, GJ = 10, EIy = 0.01, EIz = 10 }
[rod.left]
section = "s"
line = { from = [-10, 0, 0], to = [0, 0, 1] }
elements = 1
[rod.right]
section = "s"
line = { from = [0, 0, 1], to = [10, 0, 0] }
elements = 1
[[connect]]
points = ["left.end", "right.start"]
[[support]]
at = "left.start"
fix = ["position", "rx", "rz"]
[[support]]
at = "right.end"
fix = ["position", "rx", "rz"]
[[support]]
at = "left.end"
fix = ["x", "y", "rx", "ry", "rz"]
[[load]]
at = "left.end"
force = [0, 0, -5]
[analysis]
kind = "static"
steps = 20
)deck";

struct Outcome {
    EnergyJumps jumps;
    std::string warning;
};

Outcome run(const std::string& deck, const std::vector<std::string>& overrides = {}) {
    const Problem problem = read(deck, overrides);
    const RunRequest request{problem};
    const RunSummary summary = run_analysis(request);
    REQUIRE(summary.status == RunStatus::complete);
    return {summary.totals.jumps,
            describe_imbalance(summary.energy(), compute_energy_round_off(problem.model))};
}

}  // namespace

TEST_CASE("Slack chains, risers and columns on one path of equilibria do not jump", "[issues][static]") {
    for (const std::string& deck : {chain, riser, column}) {
        for (const std::string steps : {"3", "5", "10", "20"}) {
            INFO(deck << steps << " steps");
            CHECK(run(deck, {"analysis.steps=" + steps}).warning == "");
        }
    }
}

TEST_CASE("A chain that is hauled in under its growing weight does not jump", "[issues][static]") {
    std::string deck = replaced(chain,
                                "polyline = [[0, 0, 0], [30, 0, -40], [80, 0, 0]]",
                                "line = { from = [0, 0, 0], to = [100, 0, 0] }");
    deck = replaced(deck,
                    "at = \"c.end\"\nfix = [\"position\"]",
                    "at = \"c.end\"\nfix = [\"y\", \"z\"]\nmove = { x = \"-20*t\" }");
    CHECK(run(deck).warning == "");
    CHECK(run(deck, {"analysis.steps=20"}).warning == "");
}

TEST_CASE("An arch that snaps through is reported with where it does", "[issues][static]") {
    for (const int steps : {10, 20, 40}) {
        INFO(steps << " steps");
        const Outcome snapped = run(arch, {"analysis.steps=" + std::to_string(steps)});
        CHECK_THAT(snapped.warning, Catch::StartsWith("the structure jumps between t = "));
        CHECK(snapped.jumps.count >= 1);
        CHECK(snapped.jumps.largest.to - snapped.jumps.largest.from <= 1.001 / steps);
    }
    CHECK(run(arch, {"load[0].force=[0, 0, -0.1]"}).warning == "");
    // Below the load at which it snaps.
    CHECK(run(arch, {"load[0].force=[0, 0, -1]"}).warning == "");
}

TEST_CASE("A roof that is pushed through by a support does not jump", "[issues][static]") {
    // Its reaction grows, falls, pulls and pushes again: along all of it the path is smooth.
    std::string deck = replaced(roof, "[[load]]\nat = \"left.end\"\nforce = [0, 0, -5]\n", "");
    deck = replaced(deck,
                    "fix = [\"x\", \"y\", \"rx\", \"ry\", \"rz\"]",
                    "fix = [\"x\", \"y\", \"rx\", \"ry\", \"rz\"]\nmove = { z = \"-2.5*t\" }");
    for (const std::string steps : {"10", "20", "40"}) {
        INFO(steps << " steps");
        CHECK(run(deck, {"analysis.steps=" + steps}).warning == "");
    }
}

TEST_CASE("A study calls no series right once the structure has jumped", "[issues]") {
    const std::vector<HistoryRequest> ends = make_end_histories(read(arch).model);
    Problem problem = read(arch);
    problem.output.histories = ends;
    const std::vector<Series> series = list_series(problem.output);
    const TraceRequest request{series, {0.0, 0.5, 1.0}};
    const MotionTrace trace = trace_motion(problem, request);
    REQUIRE(trace.is_whole());
    CHECK(trace.is_unstable);
    REQUIRE(!trace.warnings.empty());
    CHECK_THAT(trace.warnings.back(), Catch::Contains("the structure jumps between t = "));
    const Problem silent = read(column);
    Problem still = read(column);
    still.output.histories = make_end_histories(silent.model);
    const std::vector<Series> of_column = list_series(still.output);
    CHECK_FALSE(trace_motion(still, {of_column, {0.0, 0.5, 1.0}}).is_unstable);
}

}  // namespace gxrod::test
