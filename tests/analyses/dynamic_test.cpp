#include "analyses/dynamic.hpp"

#include <limits>

#include "integrators/scheme_samples.hpp"
#include "model/evaluation_error.hpp"
#include "tools/catch.hpp"
#include "tools/difference.hpp"
#include "tools/free_flight.hpp"
#include "tools/run.hpp"
#include "tools/tops.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

// A rod and a body that spin so fast that a step of 0.2 turns them by more than π, one of 0.1 by less.
Model make_spinning_rod() {
    Model model = make_free_flight(3);
    for (Node& node : model.nodes) node.angular_velocity = 21.0 * Vec3(-0.6, 0.8, 0.0);
    model.bodies.push_back({"rider", 1, 2.0, Vec3(1.0, 2.0, 2.0).asDiagonal(), Vec3(0.1, 0.0, 0.2)});
    return model;
}

bool are_equal(const State& a, const State& b) {
    bool equal = a.time == b.time;
    for (std::size_t i = 0; i < a.trial.size(); ++i) {
        equal = equal && a.trial[i].r == b.trial[i].r &&
                a.trial[i].Lambda.coeffs() == b.trial[i].Lambda.coeffs() &&
                a.trial[i].theta == b.trial[i].theta && stack_rates(a.trial[i]) == stack_rates(b.trial[i]) &&
                a.previous[i].r == b.previous[i].r &&
                stack_rates(a.previous[i]) == stack_rates(b.previous[i]);
    }
    for (std::size_t p = 0; p < a.sections.size(); ++p) {
        equal = equal && a.sections[p].K == b.sections[p].K &&
                a.sections[p].Lambda.coeffs() == b.sections[p].Lambda.coeffs();
    }
    return equal;
}

// A body under a moment that is `value(t)` and constant otherwise.
Model make_loaded_body(std::function<double(double)> value) {
    Model model = make_free_body(Vec3(1.0, 2.0, 3.0), Vec3(1.0, 0.5, 0.0));
    NodalLoad load;
    load.moment[2] = TimeFunction(std::move(value));
    model.loads.push_back(load);
    return model;
}

}  // namespace

TEST_CASE("a run makes its steps and meets its end", "[analyses]") {
    const Model model = make_loaded_body([](double t) { return t; });
    DynamicAnalysis kept(model, make_settings(Scheme::newmark_simplified, 0.7, 7));
    REQUIRE(kept.start().converged());
    CHECK(kept.state().time == 0.0);
    CHECK((kept.state().trial[0].alpha - Vec3(0.0, 0.0, -0.5 / 3.0)).norm() < 1e-15);
    long steps = 0;
    while (!kept.finished()) {
        REQUIRE(kept.advance().converged());
        ++steps;
        CHECK(kept.solver_row().time_step == 0.1);
        CHECK(kept.solver_row().rejected_steps == 0);
        CHECK(kept.solver_row().newton_iterations > 0);
        CHECK(kept.solver_row().residual <= 1e-10);
    }
    CHECK(steps == 7);
    CHECK(kept.state().time == 0.7);
}

TEST_CASE("loads are asked at the times of the grid to the last bit", "[analyses]") {
    for (const Scheme scheme : {Scheme::newmark_simplified, Scheme::sdirk_4, Scheme::runge_kutta_4}) {
        std::vector<double> asked;
        const Model model = make_loaded_body([&](double t) {
            asked.push_back(t);
            return 1.0;
        });
        std::vector<double> accepted;
        run(model, make_settings(scheme, 1.0, 10), [&](const DynamicAnalysis& analysis) {
            accepted.push_back(analysis.state().time);
            CHECK(std::count(asked.begin(), asked.end(), analysis.state().time) > 0);
        });
        CHECK(accepted[3] == 0.3);  // 0.2 + 0.1 > 0.3 in doubles
        if (scheme != Scheme::newmark_simplified) continue;
        for (const double time : asked) CHECK(std::count(accepted.begin(), accepted.end(), time) == 1);
    }
}

TEST_CASE("a step that fails is halved from the state as it was", "[analyses]") {
    // Bit for bit the run that takes the short steps from the start.
    const Model model = make_spinning_rod();
    for (const SchemeSample& scheme : all_schemes()) {
        if (scheme.settings.scheme == Scheme::runge_kutta_4) continue;
        INFO(scheme.name);
        DynamicSettings settings = scheme.settings;
        settings.end_time = 0.4;
        settings.steps = 2;
        DynamicAnalysis cut(model, settings);
        settings.steps = 4;
        DynamicAnalysis fine(model, settings);
        REQUIRE(cut.start().converged());
        REQUIRE(fine.start().converged());
        for (int step = 0; step < 2; ++step) {
            REQUIRE(cut.advance().converged());
            REQUIRE(fine.advance().converged());
            CHECK(cut.solver_row().rejected_steps == (step == 0 ? 1 : 0));
            CHECK(cut.solver_row().time_step == 0.1);
            CHECK(are_equal(cut.state(), fine.state()));
        }
        CHECK(cut.ledger_row().external_work == fine.ledger_row().external_work);
    }
}

TEST_CASE("a run gives up after ten halvings and stays at its last step", "[analyses]") {
    const Model model = make_loaded_body(
        [](double t) { return t > 0.3000001 ? std::numeric_limits<double>::quiet_NaN() : 1.0; });
    for (const SchemeSample& scheme : all_schemes()) {
        INFO(scheme.name);
        DynamicSettings settings = scheme.settings;
        settings.end_time = 1.0;
        settings.steps = 10;
        DynamicAnalysis analysis(model, settings);
        REQUIRE(analysis.start().converged());
        for (int step = 0; step < 3; ++step) REQUIRE(analysis.advance().converged());
        const State before = analysis.state();
        const LedgerRow row = analysis.ledger_row();
        const EquilibriumReport report = analysis.advance();
        CHECK(report.outcome == Outcome::not_finite);
        CHECK(report.worst_node == 0);
        CHECK(report.worst_component == 5);
        CHECK(analysis.solver_row().rejected_steps == 11);
        CHECK(analysis.state().time == 0.3);
        CHECK(are_equal(analysis.state(), before));
        CHECK(analysis.ledger_row().external_work == row.external_work);
        CHECK(analysis.ledger_row().kinetic_energy == row.kinetic_energy);
        CHECK_FALSE(analysis.finished());
    }
}

TEST_CASE("a load without a value ends a run at its last step", "[analyses]") {
    const Model model = make_loaded_body([](double t) -> double {
        if (t > 0.3000001) throw EvaluationError("load[0].moment[2] at t = 0.4");
        return 1.0;
    });
    DynamicAnalysis analysis(model, make_settings(Scheme::newmark_simplified, 1.0, 10));
    REQUIRE(analysis.start().converged());
    for (int step = 0; step < 3; ++step) REQUIRE(analysis.advance().converged());
    const State before = analysis.state();
    CHECK_THROWS_AS(analysis.advance(), EvaluationError);
    CHECK(are_equal(analysis.state(), before));
}

TEST_CASE("initial accelerations that cannot be found are reported", "[analyses]") {
    const Model model = make_free_body(Vec3(1.0, 0.0, 1.0), Vec3::Zero());
    DynamicAnalysis analysis(model, make_settings(Scheme::newmark_simplified, 1.0, 10));
    const EquilibriumReport report = analysis.start();
    CHECK(report.outcome == Outcome::singular);
    CHECK(report.worst_component == 4);
}

TEST_CASE("a snapshot holds reactions at supports and nothing elsewhere", "[analyses]") {
    // A body that hangs still.
    Model model = heavy_top::make_model();
    model.bodies[0].centre_of_mass = Vec3(0.0, 0.0, -1.0);
    model.nodes[0].angular_velocity.setZero();
    DynamicAnalysis hanging(model, make_settings(Scheme::newmark_simplified, 1.0, 10));
    REQUIRE(hanging.start().converged());
    REQUIRE(hanging.advance().converged());
    Vec6 expected = Vec6::Zero();
    expected[2] = 15.0 * 9.81;
    CHECK(hanging.snapshot().time == 0.1);
    CHECK((hanging.snapshot().reactions[0] - expected).norm() < 1e-11);
    // A top in motion: what its momentum changes by, less gravity.
    std::vector<Vec3> momenta, reactions;
    const Model top = heavy_top::make_model();
    DynamicAnalysis turning(top, make_settings(Scheme::runge_kutta_4, 0.01, 400));
    REQUIRE(turning.start().converged());
    while (!turning.finished()) {
        REQUIRE(turning.advance().converged());
        momenta.push_back(turning.ledger_row().linear_momentum);
        reactions.push_back(turning.snapshot().reactions[0].head<3>());
        CHECK(turning.snapshot().reactions[0].tail<3>().isZero(0.0));
    }
    const std::size_t middle = 200;
    const double dt = 0.01 / 400.0;
    const Vec3 change = (momenta[middle + 1] - momenta[middle - 1]) / (2.0 * dt);
    CHECK(relative_difference(reactions[middle], change - 15.0 * top.gravity(0.0)) < 1e-5);
}

TEST_CASE("a snapshot holds the section values of every element", "[analyses]") {
    const Model model = make_free_flight(3);
    DynamicAnalysis analysis(model, make_settings(Scheme::newmark_simplified, 5.0, 100));
    REQUIRE(analysis.start().converged());
    for (int step = 0; step < 20; ++step) REQUIRE(analysis.advance().converged());
    const Snapshot snapshot = analysis.snapshot();
    REQUIRE(snapshot.elements.size() == 3);
    REQUIRE(snapshot.nodes.size() == 4);
    for (const SectionValues& values : snapshot.elements) {
        CHECK(values.moment.norm() > 0.1);
        CHECK(relative_difference(values.moment, 500.0 * values.curvature) < 1e-13);
        CHECK(relative_difference(values.force, 1e4 * values.strain) < 1e-13);
    }
}

namespace {

DynamicSettings make_adaptive(double end_time, long steps, const AdaptiveSettings& adaptive) {
    DynamicSettings settings = make_settings(Scheme::sdirk_4, end_time, steps);
    settings.adaptive = adaptive;
    return settings;
}

struct AdaptiveRun {
    double error;  // of the heavy top's centre of mass at t = 1
    long steps;
};

AdaptiveRun run_heavy_top(double tolerance) {
    const Model model = heavy_top::make_model();
    DynamicAnalysis analysis(model, make_adaptive(1.0, 1000, {.tolerance = tolerance}));
    REQUIRE(analysis.start().converged());
    while (!analysis.finished()) REQUIRE(analysis.advance().converged());
    CHECK(analysis.state().time == 1.0);
    const Vec3 centre = heavy_top::centre_of_mass(analysis.state().trial[0].Lambda);
    return {(centre - heavy_top::references()[1].centre_of_mass).norm(), analysis.steps().steps_done()};
}

}  // namespace

TEST_CASE("the error of a run falls with its tolerance", "[analyses]") {
    std::vector<AdaptiveRun> runs;
    for (const double tolerance : {1e-3, 1e-4, 1e-5, 1e-6}) runs.push_back(run_heavy_top(tolerance));
    for (std::size_t i = 1; i < runs.size(); ++i) {
        UNSCOPED_INFO("errors " << runs[i - 1].error << " " << runs[i].error << ", steps " << runs[i].steps);
    }
    for (std::size_t i = 1; i < runs.size(); ++i) {
        const double ratio = runs[i - 1].error / runs[i].error;
        CHECK(ratio > 5.0);
        CHECK(ratio < 20.0);
        // A fourth root of ten more steps.
        CHECK(static_cast<double>(runs[i].steps) / static_cast<double>(runs[i - 1].steps) ==
              Approx(std::pow(10.0, 0.25)).epsilon(0.1));
    }
}

TEST_CASE("steps are short while a load hammers and long when it is over", "[analyses]") {
    const Model model = make_loaded_body([](double t) { return t < 1.0 ? 30.0 * std::sin(60.0 * t) : 0.0; });
    DynamicAnalysis analysis(model, make_adaptive(10.0, 1000, {.tolerance = 1e-6, .max_step = 2.0}));
    REQUIRE(analysis.start().converged());
    double longest_loaded = 0.0;
    double longest_free = 0.0;
    long rejected = 0;
    while (!analysis.finished()) {
        const double start = analysis.state().time;
        REQUIRE(analysis.advance().converged());
        const SolverRow& row = analysis.solver_row();
        CHECK(analysis.state().time == Approx(start + row.time_step).epsilon(1e-14));
        double& longest = analysis.state().time < 1.0 ? longest_loaded : longest_free;
        if (start > 0.2) longest = std::max(longest, row.time_step);
        rejected += row.rejected_steps;
    }
    CHECK(analysis.state().time == 10.0);
    CHECK(longest_free > 4.0 * longest_loaded);
    CHECK(rejected > 0);
}

TEST_CASE("two runs with error control are equal to the last bit", "[analyses]") {
    const Model model = make_spinning_rod();
    const DynamicSettings settings = make_adaptive(0.4, 2, {.tolerance = 1e-5});
    DynamicAnalysis first(model, settings);
    DynamicAnalysis second(model, settings);
    REQUIRE(first.start().converged());
    REQUIRE(second.start().converged());
    long rejected = 0;
    while (!first.finished()) {
        REQUIRE(first.advance().converged());
        REQUIRE(second.advance().converged());
        CHECK(are_equal(first.state(), second.state()));
        rejected += first.solver_row().rejected_steps;
    }
    CHECK(second.finished());
    CHECK(rejected > 0);  // the first step turns by more than π
}

TEST_CASE("a tolerance that the shortest step misses is reported", "[analyses]") {
    const Model model = heavy_top::make_model();
    DynamicAnalysis analysis(model, make_adaptive(1.0, 500, {.tolerance = 1e-9, .min_step = 1e-3}));
    REQUIRE(analysis.start().converged());
    const State before = analysis.state();
    const EquilibriumReport report = analysis.advance();
    CHECK(report.outcome == Outcome::error_too_large);
    CHECK(report.step_error > 1e-9);
    CHECK(report.worst_node == 0);
    CHECK(report.worst_component >= 3);
    CHECK(analysis.solver_row().rejected_steps == 2);
    CHECK(are_equal(analysis.state(), before));
}
