// A tangent that Newton's method keeps: it is computed once where the motion is smooth, again where the
// residual falls too slowly, and motions are those of the consistent one.

#include "analyses/dynamic.hpp"
#include "integrators/scheme_samples.hpp"
#include "solvers/equilibrium.hpp"
#include "tools/catch.hpp"
#include "tools/rod_models.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

constexpr double tolerance = 1e-10;

// A cantilever that swings under a load at its end.
Model make_swinging_cantilever() {
    const Section section = [] {
        Section damped = make_section({1e4, 1e4, 1e4, 1.0, 1.0, 1.0}, {1.0, 1.0, 1.0, 0.01, 0.01, 0.01});
        damped.kelvin_voigt = 0.01;
        return damped;
    }();
    Model model = make_rod_model(along_x, 1.0, {6, 3}, section);
    clamp(model, 0);
    add_ramp(model, last_node(model), Vec3(0.0, 4.0, 2.0), Vec3(1.0, 0.0, 0.0));
    return model;
}

DynamicSettings make_kept_settings(TangentKind tangent, long steps, double newton_tolerance = tolerance) {
    DynamicSettings settings;
    settings.end_time = 1.0;
    settings.steps = steps;
    settings.newton.tolerance = newton_tolerance;
    settings.newton.tangent = tangent;
    return settings;
}

// An equilibrium from the middle of the motion, stopped after so many iterations.
struct Stopped {
    EquilibriumReport report;
    std::vector<double> tangent;
};
Stopped stop_after(const State& start, const System& system, double step, int iterations) {
    const DynamicSettings settings = make_kept_settings(TangentKind::kept, 1);
    NewtonSettings newton = settings.newton;
    newton.max_iterations = iterations;
    State state = start;
    SolverWorkspace workspace(system, LinearSolverKind::klu);
    const auto integrator = make_integrator(settings);
    const Stage stage{0, start.time, step, start.time + step};
    const EquilibriumReport report =
        solve_equilibrium({system, *integrator, newton}, stage, workspace, state);
    return {report, workspace.values};
}

State move_to_the_middle(const Model& model) {
    DynamicAnalysis analysis(model, make_kept_settings(TangentKind::consistent, 100));
    REQUIRE(analysis.start().converged());
    for (int step = 0; step < 50; ++step) REQUIRE(analysis.advance().converged());
    return analysis.state();
}

}  // namespace

TEST_CASE("A kept tangent is that of the first iteration while the residual falls fast", "[solvers][kept]") {
    const Model model = make_swinging_cantilever();
    const System system(model);
    const State start = move_to_the_middle(model);
    const Stopped first = stop_after(start, system, 0.002, 1);
    const Stopped all = stop_after(start, system, 0.002, 20);
    CHECK(all.report.converged());
    CHECK(all.report.iterations >= 2);
    CHECK(all.tangent == first.tangent);
    REQUIRE(all.report.iterations <= 6);
}

TEST_CASE("A kept tangent is computed again where the residual falls slowly", "[solvers][kept]") {
    const Model model = make_swinging_cantilever();
    const System system(model);
    const State start = move_to_the_middle(model);
    const Stopped first = stop_after(start, system, 0.2, 1);
    const Stopped all = stop_after(start, system, 0.2, 20);
    CHECK(all.report.converged());
    CHECK(all.tangent != first.tangent);
}

TEST_CASE("Motions by a kept tangent are those by the consistent one", "[solvers][kept]") {
    const Model model = make_swinging_cantilever();
    for (const SchemeSample& scheme : all_schemes()) {
        if (scheme.is_coupled() || scheme.settings.scheme == Scheme::runge_kutta_4) continue;
        if (scheme.settings.beta < 0.25) continue;  // conditionally stable
        INFO(scheme.name);
        const auto move = [&](TangentKind tangent) {
            DynamicSettings settings = scheme.settings;
            const DynamicSettings own = make_kept_settings(tangent, 100, 1e-12);
            settings.end_time = own.end_time;
            settings.steps = own.steps;
            settings.newton = own.newton;
            DynamicAnalysis analysis(model, settings);
            REQUIRE(analysis.start().converged());
            while (!analysis.finished()) REQUIRE(analysis.advance().converged());
            return analysis.state().trial.back();
        };
        const NodeMotion kept = move(TangentKind::kept);
        const NodeMotion consistent = move(TangentKind::consistent);
        CHECK(consistent.r.y() > 0.1);
        CHECK((kept.r - consistent.r).norm() < 1e-9);
        CHECK(kept.Lambda.angularDistance(consistent.Lambda) < 1e-9);
    }
}
