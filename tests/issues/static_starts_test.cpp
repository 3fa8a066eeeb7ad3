#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "analyses/static.hpp"
#include "deck/decks.hpp"
#include "run/run.hpp"
#include "tools/catch.hpp"

// Statics that start far from equilibrium ended where no structure stays: a towed cable in compression
// against the current, an arch of a slack line, a line that stands on its hinge.

namespace gxrod::test {
namespace {

using Catch::Contains;

struct Ended {
    State state;
    Vec3 reaction = Vec3::Zero();  // at the first node
    std::vector<std::string> warnings, findings;
    std::int64_t pivots = 0;
    long rejected_steps = 0;
};

Ended run(const Problem& problem) {
    StaticAnalysis analysis(problem.model, std::get<StaticSettings>(problem.analysis()));
    REQUIRE(analysis.start().converged());
    Ended ended;
    while (!analysis.finished()) {
        const EquilibriumReport report = analysis.advance();
        if (!report.converged()) FAIL(describe_failure(analysis.explain(report)));
        ended.rejected_steps += analysis.solver_row().rejected_steps;
    }
    ended.state = analysis.state();
    ended.reaction = analysis.snapshot(false).reactions[0].head<3>();
    ended.warnings = analysis.list_warnings();
    ended.findings = analysis.list_findings();
    ended.pivots = analysis.solver_row().negative_pivots;
    return ended;
}

Vec3 end_of(const Problem& problem, const Ended& ended) {
    return ended.state.trial[static_cast<std::size_t>(problem.model.rods[0].nodes.back())].r;
}

// A cable of 300 m in a current along x, hinged at the origin, with a weight of 25 N/m.
struct Towed {
    double angle;   // of the straight line that is drawn, below x
    double length;  // along the current, negative against it
    double EA, EI, speed;
    int elements, steps;
    double weight = 25.0;  // negative: buoyancy
};

std::string make_deck(const Towed& towed) {
    return fmt::format(R"deck([fluid]
density = 1025
current = {{ velocity = [{}, 0, 0] }}
[section.cable]
stiffness = {{ EA = {}, GAy = {}, GAz = {}, GJ = {}, EIy = {}, EIz = {} }}
fluid = {{ outer_diameter = 0.05, drag = {{ normal = 1.1, tangential = 0.02 }} }}
[rod.cable]
section = "cable"
line = {{ from = [0, 0, 0], to = ["{}*cos({})", 0, "-300*sin({})"] }}
y_axis = [0, 1, 0]
elements = {}
order = 2
[[support]]
at = "cable.start"
fix = ["position", "rx", "rz"]
[[load]]
on = "cable"
force_per_length = [0, 0, {}]
[analysis]
kind = "static"
steps = {}
)deck",
                       towed.speed,
                       towed.EA,
                       towed.EA,
                       towed.EA,
                       towed.EI,
                       towed.EI,
                       towed.EI,
                       towed.length,
                       towed.angle,
                       towed.angle,
                       towed.elements,
                       -towed.weight,
                       towed.steps);
}

struct Trail {
    double angle;    // below the current
    double tension;  // at the hinge
};

// A heavy line in a uniform current is straight, where the drag across it holds the weight across it.
Trail find_trail(double speed, double weight) {
    const double drag = 0.5 * 1025 * 0.05 * speed * speed;
    const double across = 1.1 * drag;
    const double cosine = (-weight + std::sqrt(weight * weight + 4.0 * across * across)) / (2.0 * across);
    const double angle = std::acos(cosine);
    const double along = 0.02 * std::numbers::pi * drag * cosine * cosine;
    return {angle, 300.0 * (weight * std::sin(angle) + along)};
}

void check_trail(const Towed& towed, bool relaxes) {
    const std::string deck = make_deck(towed);
    INFO(deck);
    const Problem problem = read(deck);
    const Ended ended = run(problem);
    const Trail trail = find_trail(towed.speed, std::abs(towed.weight));
    const double down = towed.weight > 0.0 ? 1.0 : -1.0;
    const Vec3 end = end_of(problem, ended);
    CHECK(std::atan2(-down * end.z(), end.x()) == Approx(trail.angle).margin(1e-5));
    const Vec3 along(std::cos(trail.angle), 0.0, -down * std::sin(trail.angle));
    CHECK(-ended.reaction.dot(along) == Approx(trail.tension).epsilon(1e-5));
    CHECK(ended.warnings.empty());
    CHECK(ended.pivots <= 0);
    if (!relaxes) return;
    REQUIRE(ended.findings.size() == 1);
    CHECK_THAT(ended.findings[0], Contains("statics relaxed to the equilibrium at t = "));
}

}  // namespace

TEST_CASE("A towed cable hangs back, wherever it is drawn", "[issues]") {
    check_trail({0.35, 300, 1e7, 100, 3, 20, 20}, true);    // was in compression: -2.830 rad
    check_trail({0.11, 300, 1e9, 0.1, 4, 10, 5}, false);    // likewise, its pivots not counted
    check_trail({0.15, 300, 1e7, 1, 4, 10, 10}, true);      // likewise, without a warning
    check_trail({0.44, -300, 1e6, 0.1, 2, 40, 10}, false);  // found no equilibrium at all
    check_trail({-0.7, 300, 1e7, 100, 5, 10, 20}, true);
}

TEST_CASE("A buoyant riser that is drawn straight down stands up in a current", "[issues]") {
    check_trail({std::numbers::pi / 2.0, 300, 1e8, 1000, 0.5, 20, 10, -25.0}, true);
}

TEST_CASE("An arch of a slack line falls to the catenary", "[issues]") {
    const Problem problem = read(R"([section.s]
stiffness = { EA = 1e9, GAy = 1e9, GAz = 1e9, GJ = 1, EIy = 1, EIz = 1 }
[rod.r]
section = "s"
arc = { from = [0, 0, 0], through = [50, 0, 30], to = [100, 0, 0] }
y_axis = [0, 1, 0]
elements = 40
order = 2
[[support]]
at = "r.start"
fix = ["position", "rx", "rz"]
[[support]]
at = "r.end"
fix = ["position", "rx", "rz"]
[[load]]
on = "r"
force_per_length = [0, 0, -20]
[analysis]
kind = "static"
steps = 10
)");
    const Ended ended = run(problem);
    const auto middle = static_cast<std::size_t>(problem.model.rods[0].nodes[40]);
    // c (cosh(50/c) − 1) with 2 c sinh(50/c) the length of the arc.
    CHECK(ended.state.trial[middle].r.x() == Approx(50.0).margin(1e-3));
    CHECK(ended.state.trial[middle].r.z() == Approx(-31.23947).epsilon(1e-3));
    CHECK(ended.warnings.empty());
    CHECK(ended.findings.size() == 1);
}

TEST_CASE("A line that stands on its hinge falls, and hangs", "[issues]") {
    for (const double EI : {0.1, 1e4}) {
        const Problem problem = read(fmt::format(R"([section.s]
stiffness = {{ EA = 1e8, GAy = 1e8, GAz = 1e8, GJ = {0}, EIy = {0}, EIz = {0} }}
[rod.r]
section = "s"
line = {{ from = [0, 0, 0], to = [0, 0, 50] }}
y_axis = [0, 1, 0]
elements = 20
order = 2
[joint.h]
type = "hinge"
between = ["ground", "r.start"]
axis = [0, 1, 0]
[[load]]
on = "r"
force_per_length = [0, 0, -25]
[analysis]
kind = "static"
steps = 10
)",
                                                 EI));
        const Ended ended = run(problem);
        CHECK(end_of(problem, ended).z() == Approx(-50.0 * (1.0 + 25.0 * 50.0 / 2.0 / 1e8)).epsilon(1e-8));
        CHECK(ended.warnings.empty());
        CHECK(ended.findings.size() == 1);
    }
}

TEST_CASE("A run says that statics relaxed, and its energies balance", "[issues]") {
    const Problem problem = read(make_deck({0.35, 300, 1e7, 100, 3, 20, 20}));
    const RunSummary summary = run_analysis({problem});
    CHECK(summary.status == RunStatus::complete);
    CHECK(summary.warnings.empty());
    CHECK(summary.totals.jumps.count == 0);
    REQUIRE(summary.findings.size() == 1);
    CHECK_THAT(summary.findings[0], Contains("statics relaxed to the equilibrium at t = 0.05 in "));
}

TEST_CASE("A body on a hinge that starts level falls until it hangs", "[issues]") {
    const Problem problem = read(R"deck(gravity = [0, 0, -9.81]
[body.b]
mass = 1
inertia = [0.1, 0.1, 0.1]
at = [1, 0, 0]
[joint.pivot]
type = "hinge"
between = ["ground", "b"]
at = [0, 0, 0]
axis = [0, 1, 0]
[analysis]
kind = "static"
)deck");
    const Ended ended = run(problem);
    const Vec3& place = ended.state.trial[static_cast<std::size_t>(problem.model.bodies[0].node)].r;
    CHECK((place - Vec3(0.0, 0.0, -1.0)).norm() < 1e-8);
}

}  // namespace gxrod::test
