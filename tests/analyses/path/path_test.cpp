// Paths whose load turns back, against the elastica and against shooting by a Runge-Kutta code and spectral
// elements, which agree to the digits given.
#include "analyses/path/path.hpp"

#include <cmath>
#include <numbers>

#include "analyses/static.hpp"
#include "deck/problem.hpp"
#include "tools/path_run.hpp"
#include "tools/rod_models.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

// Planar: EIz bends.
constexpr const char* lee_frame = R"(
[section.strip]
stiffness = { EA = 4320, GAy = 1384.615384615385, GAz = 1384.615384615385, GJ = 1.44e6, EIy = 1.44e6, EIz = 1440 }
[rod.leg]
section = "strip"
line = { from = [0, 0, 0], to = [0, 120, 0] }
elements = 10
order = 4
y_axis = [1, 0, 0]
[rod.beam]
section = "strip"
line = { from = [0, 120, 0], to = [120, 120, 0] }
elements = 10
order = 4
y_axis = [0, 1, 0]
[[connect]]
points = ["leg.end", "beam.start"]
[[support]]
at = "leg.start"
fix = ["x", "y", "z", "rx", "ry"]
[[support]]
at = "beam.end"
fix = ["x", "y", "z", "rx", "ry"]
[[load]]
at = "beam@0.2"
force = [0, "-t", 0]
[analysis]
kind = "static"
steps = 10
)";

int find_node(const Model& model, const Vec3& place) {
    int nearest = 0;
    for (int i = 0; i < static_cast<int>(model.nodes.size()); ++i) {
        if ((model.nodes[i].position - place).norm() < (model.nodes[nearest].position - place).norm())
            nearest = i;
    }
    return nearest;
}

PathSettings make_path_settings() {
    PathSettings settings;
    settings.newton.tolerance = 1e-11;
    return settings;
}

// A clamped column of length 1 with EI = 1, EA = GA = 1e4, and dead loads at its tip that grow with t.
Model make_column(double side) {
    Model model = make_rod_model(along_x, 1.0, {8, 4}, make_section({1e4, 1e4, 1e4, 1e3, 1e3, 1.0}));
    clamp(model, 0);
    NodalLoad load;
    load.node = last_node(model);
    load.force[0] = ramp(-1.0);
    if (side != 0.0) load.force[1] = ramp(side);
    model.loads.push_back(load);
    return model;
}

}  // namespace

TEST_CASE("Lee's frame is followed through both limit points to six times the load unit", "[analyses]") {
    const Problem problem = read_problem_text(lee_frame, "lee.toml");
    const int node = find_node(problem.model, {24.0, 120.0, 0.0});
    PathSettings settings = make_path_settings();
    settings.greatest_load = 6.0;
    settings.at = {{node, 1, {-20.0, -40.0, -60.0, -80.0, -90.0}}};
    const PathRun run = run_path(problem.model, settings, node);
    CHECK(run.places.back().load == 6.0);
    CHECK(run.steps <= 90);
    CHECK(run.iterations <= 400);
    REQUIRE(run.points.size() == 2);
    for (const CriticalPoint& point : run.points) CHECK(point.kind == CriticalKind::limit);
    CHECK(run.points[0].load_factor == Approx(1.854452709444).epsilon(1e-8));
    CHECK(run.at_points[0].moved[1] == Approx(-48.754240378).epsilon(1e-7));
    CHECK(run.at_points[0].moved[0] == Approx(26.878327656).epsilon(1e-7));
    CHECK(run.points[1].load_factor == Approx(-0.939248964035).epsilon(1e-8));
    CHECK(run.at_points[1].moved[0] == Approx(90.177000608).epsilon(1e-7));
    CHECK(run.points[0].pivots_after == 1);
    CHECK(run.points[1].pivots_after == 0);
    CHECK(run.find(1, -20.0).load == Approx(1.344678462440).epsilon(1e-8));
    CHECK(run.find(1, -40.0).load == Approx(1.779359679181).epsilon(1e-8));
    CHECK(run.find(1, -60.0, 0).load == Approx(1.483172755040).epsilon(1e-8));
    CHECK(run.find(1, -60.0, 1).load == Approx(0.857865460941).epsilon(1e-8));
    CHECK(run.find(1, -60.0, 2).load == Approx(-0.931431556246).epsilon(1e-8));
    CHECK(run.find(1, -80.0).load == Approx(-0.348941191963).epsilon(1e-8));
    CHECK(run.find(1, -90.0).load == Approx(0.704622441269).epsilon(1e-8));
    CHECK(run.worst_energy_error < 0.02);
}

TEST_CASE("a path hits asked load factors exactly, as statics finds them", "[analyses]") {
    const Model model = make_column(0.1);
    PathSettings settings = make_path_settings();
    settings.greatest_load = 5.0;
    settings.at = {{-1, 0, {1.0, 2.5}}};
    const PathRun run = run_path(model, settings, last_node(model));
    const auto has = [&](double load) {
        return std::any_of(run.places.begin(), run.places.end(), [&](const PathPlace& place) {
            return std::abs(place.load - load) < 1e-14;
        });
    };
    CHECK(has(1.0));
    CHECK(has(2.5));
    CHECK(run.places.back().load == 5.0);
    CHECK(run.points.empty());
}

TEST_CASE("a column's bifurcation is found, and its branch is the elastica", "[analyses]") {
    const Model model = make_column(0.0);
    PathSettings settings = make_path_settings();
    settings.greatest_load = 4.0;
    const PathRun main = run_path(model, settings, last_node(model));
    REQUIRE(main.points.size() == 1);
    const CriticalPoint& point = main.points[0];
    CHECK(point.kind == CriticalKind::bifurcation);
    CHECK(point.branching == Branching::supercritical);
    CHECK(point.multiplicity == 1);
    CHECK(point.load_factor == Approx(std::numbers::pi * std::numbers::pi / 4.0).epsilon(1e-7));
    CHECK(point.pivots_before == 0);
    CHECK(point.pivots_after == 1);
    REQUIRE(main.branches.size() == 2);
    CHECK(main.branches[0].side == -main.branches[1].side);
    REQUIRE(main.findings.size() == 1);
    CHECK_THAT(main.findings[0],
               Catch::StartsWith("bifurcation at λ = 2.4674011") &&
                   Catch::Contains("two branches leave (supercritical pitchfork, stable at first)") &&
                   Catch::EndsWith("the path beyond is unstable (1 negative pivot)"));
    // At 60 and 120 degrees of the tip.
    settings.greatest_load.reset();
    settings.arc = 0.8;
    settings.at = {{-1, 0, {2.84175425875079, 4.65055973791081}}};
    for (const BranchStart& start : main.branches) {
        const PathRun branch = run_path(model, settings, last_node(model), &start);
        const double sign = branch.places[1].moved[1] > 0.0 ? 1.0 : -1.0;
        int found = 0;
        for (const PathPlace& place : branch.places) {
            CHECK(place.pivots == 0);
            const double load = place.load;
            if (std::abs(load - 2.84175425875079) < 1e-13) {
                ++found;
                CHECK(sign * place.moved[1] == Approx(0.593207646164885).epsilon(1e-8));
                CHECK(1.0 + place.moved[0] + load / 1e4 == Approx(0.741019606076327).epsilon(1e-8));
            }
            if (std::abs(load - 4.65055973791081) < 1e-13) {
                ++found;
                CHECK(sign * place.moved[1] == Approx(0.803170990007465).epsilon(1e-8));
            }
        }
        CHECK(found == 2);
    }
}

TEST_CASE("a path that is resumed takes the same steps", "[analyses]") {
    const Problem problem = read_problem_text(lee_frame, "lee.toml");
    PathSettings settings = make_path_settings();
    settings.steps = 12;
    PathAnalysis whole(problem.model, settings);
    REQUIRE(whole.start().converged());
    RestartRecord record;
    for (int i = 0; i < 12; ++i) {
        REQUIRE(whole.advance().converged());
        if (i == 5) record = whole.restart_record();
    }
    PathAnalysis resumed(problem.model, settings);
    REQUIRE(resumed.resume(record));
    while (!resumed.finished()) REQUIRE(resumed.advance().converged());
    CHECK(resumed.row().load_factor == whole.row().load_factor);
    CHECK(resumed.steps().time() == whole.steps().time());
    CHECK(resumed.ledger_row().external_work == whole.ledger_row().external_work);
    for (std::size_t i = 0; i < whole.state().trial.size(); ++i)
        CHECK(resumed.state().trial[i].r == whole.state().trial[i].r);
}

TEST_CASE("a path continues from where statics end, and so do its energies", "[analyses]") {
    const Problem problem = read_problem_text(lee_frame, "lee.toml");
    StaticSettings statics;
    statics.steps = 10;
    statics.newton.tolerance = 1e-11;
    StaticAnalysis before(problem.model, statics);
    REQUIRE(before.start().converged());
    while (!before.finished()) REQUIRE(before.advance().converged());
    Model more = problem.model;
    more.loads[0].force[1] = TimeFunction([](double t) { return -1.0 - t; });
    const int node = find_node(more, {24.0, 120.0, 0.0});
    PathSettings settings = make_path_settings();
    settings.greatest_load = 5.0;
    settings.at = {{node, 1, {-80.0}}};
    PathAnalysis path(more, settings);
    REQUIRE(path.start_after(before).converged());
    CHECK(path.ledger_row().external_work == before.ledger_row().external_work);
    CHECK(path.ledger_row().strain_energy == Approx(before.ledger_row().strain_energy).epsilon(1e-9));
    const double energy_error = before.ledger_row().energy_error;
    CHECK(path.ledger_row().energy_error == Approx(energy_error).margin(1e-9));
    bool is_hit = false;
    while (!path.finished()) {
        REQUIRE(path.advance().converged());
        const Vec3 place = path.state().trial[static_cast<std::size_t>(node)].r;
        if (std::abs(place.y() - 40.0) > 1e-8) continue;
        is_hit = true;
        CHECK(path.row().load_factor == Approx(-0.348941191963 - 1.0).epsilon(1e-8));
    }
    CHECK(is_hit);
    REQUIRE(path.critical_points().size() == 2);
    CHECK(path.critical_points()[0].load_factor == Approx(0.854452709444).epsilon(1e-7));
    CHECK(path.critical_points()[0].pivots_before == 0);
    CHECK(path.row().load_factor == 5.0);
}

TEST_CASE("a path cannot be resumed from statics", "[analyses]") {
    const Model model = make_column(0.0);
    StaticAnalysis statics(model, StaticSettings{});
    REQUIRE(statics.start().converged());
    PathSettings settings = make_path_settings();
    settings.steps = 3;
    PathAnalysis path(model, settings);
    CHECK_THROWS_AS(path.resume(statics.restart_record()), std::invalid_argument);
}

TEST_CASE("a path needs an end", "[analyses]") {
    const Model model = make_column(0.0);
    CHECK_THROWS_AS(PathAnalysis(model, PathSettings{}), std::invalid_argument);
}
