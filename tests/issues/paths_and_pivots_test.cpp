#include <fmt/format.h>

#include "analyses/path/path.hpp"
#include "analyses/static.hpp"
#include "check/model_examination.hpp"
#include "check/shape_report.hpp"
#include "check/static_scale.hpp"
#include "check/summaries/condition_summary.hpp"
#include "deck/decks.hpp"
#include "model/energy_round_off.hpp"
#include "run/run.hpp"
#include "tools/catch.hpp"

// Paths that crawled or lost branches, jumps and instabilities that were not there or not seen, and buckling
// of what no load makes.

namespace gxrod::test {
namespace {

using Catch::Contains;

RunSummary run(const Problem& problem) {
    RunRequest request{problem};
    return run_analysis(request);
}

// What a run warns of, jumps included.
std::string warnings_of(const Problem& problem) {
    const RunSummary summary = run(problem);
    REQUIRE(summary.status == RunStatus::complete);
    std::string text = describe_imbalance(summary.energy(), compute_energy_round_off(problem.model));
    for (const std::string& warning : summary.warnings) text += warning + "\n";
    return text;
}

std::string errors_of(const Problem& problem) {
    std::string text;
    for (const Finding& finding : examine_stages(problem.model, problem.stages)) {
        if (finding.severity == Severity::error) text += finding.message + "\n";
    }
    return text;
}

// A beam along x from a clamp, with what acts on it.
std::string beam(const std::string& text, const std::string& section = "") {
    return R"(gravity = [0, 0, -1]
[section.bar]
stiffness = { EA = 1e3, GAy = 500, GAz = 500, GJ = 1, EIy = 1, EIz = 1.5 }
inertia = { rhoA = 1, rhoJ = 0.02, rhoIy = 0.01, rhoIz = 0.01 }
)" + section +
           R"([rod.beam]
section = "bar"
line = { from = [0, 0, 0], to = [1, 0, 0] }
elements = 6
order = 2
y_axis = [0, 1, 0]
[[support]]
at = "beam.start"
fix = "all"
)" + text;
}

Vec3 move_of_end(const Problem& problem, const SteppedAnalysis& analysis) {
    const auto node = static_cast<std::size_t>(problem.model.rods[0].nodes.back());
    return analysis.state().trial[node].r - problem.model.nodes[node].position;
}

Vec3 find_static_end(const std::string& deck) {
    const Problem problem = read(deck + "[analysis]\nkind = \"static\"\nsteps = 10\n");
    StaticAnalysis analysis(problem.model, std::get<StaticSettings>(problem.analysis()));
    REQUIRE(analysis.start().converged());
    while (!analysis.finished()) REQUIRE(analysis.advance().converged());
    return move_of_end(problem, analysis);
}

// The path to t = 1 ends where statics do, and in as few steps as a path by loads alone.
void check_path(const std::string& deck, int most_steps) {
    INFO(deck);
    const Problem problem = read(deck + "[analysis]\nkind = \"path\"\nuntil = { t = 1, steps = 60 }\n");
    PathAnalysis analysis(problem.model, std::get<PathSettings>(problem.analysis()));
    REQUIRE(analysis.start().converged());
    int steps = 0;
    for (; !analysis.finished(); ++steps) REQUIRE(analysis.advance().converged());
    CHECK(steps <= most_steps);
    CHECK(analysis.row().load_factor == Approx(1.0).epsilon(1e-12));
    const Vec3 expected = find_static_end(deck);
    CHECK((move_of_end(problem, analysis) - expected).norm() < 1e-6);
}

// A bar that is hinged at its foot, whose head slides down a wall: it snaps through at 14.802588.
std::string toggle(const std::string& analysis, const std::string& force) {
    return R"(plane = "xy"
[section.bar]
stiffness = { EA = 1e4, GAy = 1e4, GAz = 1e4, GJ = 1e4, EIy = 1e4, EIz = 1e4 }
[rod.bar]
section = "bar"
line = { from = [-10, 0, 0], to = [0, 2, 0] }
elements = 2
order = 2
[[support]]
at = "bar.start"
fix = "position"
[[support]]
at = "bar.end"
fix = ["x", "z"]
[[load]]
at = "bar.end"
force = [0, ")" +
           force + R"(", 0]
[analysis]
)" + analysis;
}

int count_passes(const std::string& until, double value) {
    const Problem problem = read(
        toggle("kind = \"path\"\n" + until + "\nat = [{ t = [" + fmt::format("{}", value) + "] }]\n", "-t"));
    PathAnalysis analysis(problem.model, std::get<PathSettings>(problem.analysis()));
    REQUIRE(analysis.start().converged());
    int passes = 0;
    while (!analysis.finished()) {
        REQUIRE(analysis.advance().converged());
        passes += std::abs(analysis.row().load_factor - value) < 1e-9 ? 1 : 0;
    }
    return passes;
}

BucklingRecord find_factors(const std::string& deck) {
    const RunSummary summary = run(read(deck));
    REQUIRE(summary.shapes.size() == 1);
    return std::get<BucklingRecord>(summary.shapes[0].record);
}

}  // namespace

TEST_CASE("A path with what acts within sections ends where statics end", "[issues][path]") {
    check_path(beam("[tendon.pull]\non = \"beam\"\noffset = [0, 0.05]\ntension = 2\n"), 15);
    check_path(beam("[[actuation]]\non = \"beam\"\ncurvature = [0, 0, 1]\n"), 15);
    check_path(beam("[[actuation]]\non = \"beam\"\ntemperature_gradient = [50, 0]\n", "expansion = 1e-2\n"),
               15);
}

TEST_CASE("A path that crawls ends with a clear message", "[issues][path]") {
    PathSettings settings;
    settings.max_step = 0.2;
    // A number of steps next to another end is a bound on the work.
    SECTION("to a load") { settings.greatest_load = 1.0; }
    SECTION("to a load, in so many steps") {
        settings.greatest_load = 1.0;
        settings.steps = 300;
    }
    PathSequence steps(settings);
    steps.start(0.1);
    steps.accept();
    for (int i = 0; i < 200; ++i) {
        CHECK_FALSE(steps.is_crawling());
        steps.start(1e-6);
        steps.adapt(20);
        steps.accept();
    }
    CHECK(steps.is_crawling());
    CHECK_FALSE(steps.reject());
    Failure failure;
    failure.phase = Failure::Phase::load_step;
    failure.outcome = Outcome::path_crawls;
    CHECK_THAT(describe_failure(failure), Contains("the path crawls") && Contains("until.steps"));
}

TEST_CASE("Branches are followed to both sides at the usual tolerance", "[issues][path]") {
    // A hinged arch of 215° that sways from 327.63 on; its branches bear 411.08.
    const RunSummary summary = run(read(R"deck(plane = "xy"
[parameters]
half = "215*pi/360"
[section.strip]
stiffness = { EA = 1e8, GAy = 1e8, GAz = 1e8, GJ = 1e6, EIy = 1e6, EIz = 1e6 }
[rod.arch]
section = "strip"
arc = { centre = [0, 0, 0], axis = [0, 0, 1], from = ["100*sin(half)", "100*cos(half)", 0], angle = "2*half" }
elements = 32
order = 3
[[support]]
at = "arch.start"
fix = ["x", "y"]
[[support]]
at = "arch.end"
fix = ["x", "y"]
[[load]]
at = "arch@0.5"
force = [0, -1, 0]
[analysis]
kind = "path"
until = { t = [0, 950], points = 1 }
max_step = 0.05
branches = 1
)deck"));
    REQUIRE(summary.status == RunStatus::complete);
    CHECK(summary.warnings.empty());
    REQUIRE(summary.paths.size() == 1);
    const PathRecord& paths = summary.paths[0];
    REQUIRE(paths.size() == 3);
    REQUIRE(paths[0].points.size() == 1);
    CHECK(paths[0].points[0].load_factor == Approx(327.6277845).epsilon(1e-7));
    for (const std::size_t branch : {1, 2}) {
        REQUIRE(paths[branch].points.size() == 1);
        CHECK(paths[branch].points[0].kind == CriticalKind::limit);
        CHECK(paths[branch].points[0].load_factor == Approx(411.0760129733).epsilon(1e-7));
    }
}

TEST_CASE("A path hits asked values on both sides of where the load turns back", "[issues][path]") {
    // The limits are ±14.802588 (path with small steps): 14.8 is passed upwards, downwards and upwards again.
    for (const std::string critical : {"locate", "off"}) {
        INFO(critical);
        const std::string until = "until = { t = [-20, 20] }\ncritical = \"" + critical + "\"";
        CHECK(count_passes(until, 14.8) == 3);
        CHECK(count_passes(until, 14.5) == 3);
        CHECK(count_passes(until, -14.8) == 2);
        CHECK(count_passes(until, 14.81) == 1);
    }
}

TEST_CASE("Long steps over a limit load are reported as jumps", "[issues][static]") {
    const std::array<std::pair<int, int>, 10> cases{
        {{40, 1}, {60, 1}, {60, 2}, {80, 1}, {80, 2}, {100, 3}, {150, 1}, {150, 2}, {150, 5}, {200, 3}}};
    for (const auto& [force, steps] : cases) {
        INFO(force << " in " << steps << " steps");
        const std::string deck =
            toggle(fmt::format("kind = \"static\"\nsteps = {}\n", steps), fmt::format("-{}*t", force));
        // Or it relaxes at once to the equilibrium beyond, and says so.
        const RunSummary summary = run(read(deck));
        const std::string words =
            fmt::format("{}\n{}", fmt::join(summary.warnings, "\n"), fmt::join(summary.findings, "\n"));
        CHECK_THAT(words, Contains("the structure jumps") || Contains("statics relaxed to the equilibrium"));
    }
    // Below the limit nothing jumps, and with a fine mesh of steps neither.
    CHECK(warnings_of(read(toggle("kind = \"static\"\nsteps = 1\n", "-12*t"))) == "");
    CHECK(warnings_of(read(toggle("kind = \"static\"\nsteps = 5\n", "200*t"))) == "");
}

TEST_CASE("The factor of buckling multiplies moves of supports", "[issues][shapes]") {
    const std::string held =
        "gravity = [0, 0, 0]\n" + beam("[[support]]\nat = \"beam.end\"\nfix = [\"y\", \"z\"]\n")
                                      .substr(std::string("gravity = [0, 0, -1]\n").size());
    const std::string analysis = "[analysis]\nkind = \"buckling\"\ncount = 2\n";
    const BucklingRecord by_move = find_factors(
        replaced(held, "fix = [\"y\", \"z\"]\n", "fix = [\"y\", \"z\"]\nmove = { x = -0.002 }\n") + analysis);
    // The move presses with EA 0.002 / 1.
    const BucklingRecord by_force =
        find_factors(held + "[[load]]\nat = \"beam.end\"\nforce = [-2, 0, 0]\n" + analysis);
    REQUIRE(by_move.factors.size() == 2);
    REQUIRE(by_force.factors.size() == 2);
    for (const std::size_t i : {0, 1})
        CHECK(by_move.factors[i].factor == Approx(by_force.factors[i].factor).epsilon(1e-6));
    CHECK(by_move.factors[0].factor == Approx(9.9).margin(0.3));  // 20.19/2, less by shear
    CHECK(by_move.is_complete);
}

TEST_CASE("The factor of buckling multiplies motors and drives of joints", "[issues][shapes]") {
    const std::string pressed =
        replaced(beam("[joint.press]\ntype = \"slider\"\nbetween = [\"ground\", \"beam.end\"]\n"
                      "axis = [1, 0, 0]\nACTS\n"),
                 "gravity = [0, 0, -1]",
                 "gravity = [0, 0, 0]");
    const auto factor_of = [&](const std::string& acts, const std::string& analysis) {
        return find_factors(replaced(pressed, "ACTS", acts) + analysis).factors.at(0).factor;
    };
    const std::string alone = "[analysis]\nkind = \"buckling\"\n";
    const std::string after_statics =
        "[[stage]]\nname = \"press\"\nkind = \"static\"\nsteps = 2\n"
        "[[stage]]\nname = \"buckle\"\nkind = \"buckling\"\n";
    const std::string motor = "move = \"-0.002*t\"", drive = "drive = \"-2*t\"";
    // Both ends clamped: 4 π²/2 = 19.74, less by shear. The motor presses with EA 0.002 / 1.
    CHECK(factor_of(drive, alone) == Approx(18.44).margin(0.05));
    CHECK(factor_of(motor, alone) == Approx(factor_of(drive, alone)).epsilon(1e-6));
    CHECK(1.0 + factor_of(motor, after_statics) == Approx(factor_of(motor, alone)).epsilon(3e-3));
}

TEST_CASE("Buckling refuses what a factor cannot multiply, by its name", "[issues][shapes]") {
    const std::string analysis = "[analysis]\nkind = \"buckling\"\n";
    const std::string without = replaced(beam(""), "gravity = [0, 0, -1]", "gravity = [0, 0, 0]");
    CHECK_THAT(errors_of(read(without + analysis)),
               Contains("nothing acts that a buckling factor could multiply"));
    const std::string spring =
        "[spring.tie]\nbetween = [\"beam.end\", \"ground\"]\nat_b = [0.5, 0, 0]\nstiffness = 2\nlength = "
        "0.2\n";
    CHECK_THAT(errors_of(read(without + spring + analysis)), Contains("spring.tie"));
    const RunSummary taut = run(read(beam(spring) + analysis));
    CHECK(taut.status == RunStatus::failed);
    CHECK_THAT(taut.reason, Contains("the reference shape is not in equilibrium without its loads"));
    const std::string contents =
        "fluid = { outer_diameter = 0.04, contents = { density = 500, pressure = 10, inner_diameter = 0.02 "
        "}, poisson = 0.3 }\n";
    CHECK_THAT(errors_of(read(beam("[fluid]\ndensity = 100\n", contents) + analysis)),
               Contains("pressures of contents") && Contains("section bar"));
    CHECK_THAT(errors_of(read(
                   beam("[tendon.pull]\non = \"beam\"\noffset = [0, 0.05]\ntension = 2\nfriction = 0.1\n") +
                   analysis)),
               Contains("tendon.pull"));
}

TEST_CASE("A coarse mesh of a column is named with how much it is off", "[issues][shapes]") {
    const auto column = [](int elements, int order) {
        return read(fmt::format(R"(plane = "xy"
[section.s]
stiffness = {{ EA = 1e8, GAy = 1e8, GAz = 1e8, GJ = 1, EIy = 1, EIz = 1 }}
[rod.column]
section = "s"
line = {{ from = [0, 0, 0], to = [1, 0, 0] }}
elements = {}
order = {}
[[support]]
at = "column.start"
fix = "position"
[[support]]
at = "column.end"
fix = ["y", "z"]
[[load]]
at = "column.end"
force = [-1, 0, 0]
[analysis]
kind = "buckling"
count = 1
)",
                                elements,
                                order));
    };
    const double euler = std::pow(std::acos(-1.0), 2);
    for (const auto& [elements, order] :
         {std::pair(4, 1), std::pair(8, 1), std::pair(2, 2), std::pair(4, 2)}) {
        INFO(elements << " elements of order " << order);
        const RunSummary summary = run(column(elements, order));
        const auto record = std::get<BucklingRecord>(summary.shapes.at(0).record);
        const double error = record.factors.at(0).factor / euler - 1.0;
        CHECK(record.mesh_error > 0.9 * error);
        CHECK(record.mesh_error < 1.5 * error);
        const std::string text = fmt::format("{}", fmt::join(list_shapes(record, 5), "\n"));
        CHECK((text.find("the mesh is coarse") != std::string::npos) == (record.mesh_error > 0.02));
    }
    const RunSummary fine = run(column(8, 3));
    CHECK(std::get<BucklingRecord>(fine.shapes.at(0).record).mesh_error < 1e-6);
}

TEST_CASE("A rod that hardly stretches is stable where the elastica is", "[issues][static]") {
    for (const auto& [elements, order] : {std::pair(2, 2), std::pair(8, 1)}) {
        for (const std::string stiffness : {"1e10", "1e11"}) {
            const Problem problem = read(fmt::format(R"(plane = "xy"
[section.strip]
stiffness = {{ EA = {0}, GAy = {0}, GAz = {0}, GJ = 1, EIy = 1, EIz = 1 }}
[rod.beam]
section = "strip"
line = {{ from = [0, 0, 0], to = [1, 0, 0] }}
elements = {1}
order = {2}
[[support]]
at = "beam.start"
fix = "all"
[[load]]
at = "beam.end"
force = [0, -10, 0]
[analysis]
kind = "static"
)",
                                                     stiffness,
                                                     elements,
                                                     order));
            INFO(elements << " elements of order " << order << ", " << stiffness);
            CHECK(warnings_of(problem) == "");
        }
    }
}

TEST_CASE("Beds, bent starts and taut springs do not jump", "[issues][static]") {
    const std::string bed = "radius = 0.02\n";
    const std::string analysis = "[analysis]\nkind = \"static\"\nsteps = 10\n";
    const std::string light = replaced(beam("", bed), "gravity = [0, 0, -1]", "gravity = [0, 0, 0]");
    CHECK(warnings_of(read(light + R"([obstacle.bed]
plane = { point = [0, 0, -0.1], normal = [0, 0, 1] }
stiffness = 50
[[load]]
at = "beam.end"
force = [0, 0.2, -0.4]
)" + analysis)) == "");
    CHECK(warnings_of(read(
              beam("[spring.tie]\nbetween = [\"beam.end\", \"ground\"]\nat_b = [1, 0.5, 0]\nstiffness = 2\n"
                   "length = 0.2\n") +
              analysis)) == "");
}

TEST_CASE("A roller that moves loads a beam, and is no jump", "[issues][static]") {
    const Problem problem = read(R"(plane = "xz"
[section.s]
stiffness = { EA = 1e7, GAy = 1e10, GAz = 1e10, GJ = 1e4, EIy = 1e4, EIz = 1e4 }
radius = 0.02
[rod.b]
section = "s"
line = { from = [0, 0, 0], to = [4, 0, 0] }
elements = 16
order = 2
[[support]]
at = "b.start"
fix = "position"
[[support]]
at = "b.end"
fix = ["y", "z"]
[obstacle.roller]
cylinder = { from = [2, -1, 0.121], to = [2, 1, 0.121], radius = 0.1 }
move = { z = -0.05 }
[analysis]
kind = "static"
steps = 10
)");
    for (const Finding& finding : examine_stages(problem.model, problem.stages))
        CHECK_THAT(finding.message, !Contains("nothing loads the model"));
    CHECK(describe_static_scale(problem.model, problem.analysis()) == "");
    CHECK(warnings_of(problem) == "");
}

TEST_CASE("Pivots of loads that follow are unknown, and the run says so", "[issues][static]") {
    const Problem problem =
        read(beam("[[load]]\nat = \"beam.end\"\nforce = [0, 0.1, 0]\nframe = \"follower\"\n"
                  "[analysis]\nkind = \"static\"\nsteps = 2\n"));
    StaticAnalysis analysis(problem.model, std::get<StaticSettings>(problem.analysis()));
    REQUIRE(analysis.start().converged());
    CHECK(analysis.solver_row().negative_pivots == -1);
    REQUIRE(analysis.advance().converged());
    CHECK(analysis.solver_row().negative_pivots == -1);
    const RunSummary summary = run(problem);
    REQUIRE(summary.notes.size() == 1);
    CHECK_THAT(summary.notes[0], Contains("load[0] follows its point") && Contains("pivots do not show"));
}

TEST_CASE("A cubic curve passes a value as often as it has it", "[issues][path]") {
    // x along the row, and a value that rises to 0.25 at x = 1/2 and falls again.
    const auto vector = [](double x, double y) { return PathVector{Eigen::Vector2d(x, y), 0.0}; };
    const PathVector along = vector(1.0, 0.0), value = vector(0.0, 1.0);
    const PathCurve curve(vector(1.0, 1.0), vector(1.0, 0.0), vector(1.0, -1.0), along);
    CHECK(curve.find_first(value, 0.1875, 1e-12).value() == Approx(0.25).epsilon(1e-12));
    CHECK(curve.find_first(value, 0.24999, 1e-12).value() < 0.5);
    CHECK_FALSE(curve.find_first(value, 0.2501, 1e-12).has_value());
    // Where it begins, it has the value again at the end alone.
    CHECK(curve.find_first(value, 0.0, 1e-12).value_or(1.0) == Approx(1.0));
    CHECK(curve.at(0.5).u.y() == Approx(0.25).epsilon(1e-12));
}

TEST_CASE("Gravity that grows with the loads of statics is described so", "[issues]") {
    const auto describe = [](const std::string& gravity) {
        const Problem problem = read(replaced(
            beam("[analysis]\nkind = \"static\"\n"), "gravity = [0, 0, -1]", "gravity = " + gravity));
        std::string text;
        for (const ItemList& list : list_conditions(problem.model)) {
            for (const std::string& item : list.items) text += item;
        }
        return text;
    };
    CHECK_THAT(describe("[0, 0, -1]"), Contains("gravity grows with t, to (0, 0, -1) at t = 1"));
    CHECK_THAT(describe("[0, 0, \"-1 + 0*t\"]"), Contains("gravity (0, 0, -1)\n"));
    CHECK_THAT(describe("[0, 0, \"-t^2\"]"), Contains("gravity changes with t; at t = 1 it is (0, 0, -1)"));
}

}  // namespace gxrod::test
