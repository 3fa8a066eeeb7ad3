// How Newton's method converges: the order of its residuals, and the iterations that the paper's problem
// takes.

#include "integrators/scheme_samples.hpp"
#include "solvers/equilibrium.hpp"
#include "tools/catch.hpp"
#include "tools/free_flight.hpp"
#include "tools/run.hpp"
#include "tools/tops.hpp"
#include "verification/rubin2007_problem.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

// A state in the middle of a motion and a step from it that is long enough to need several iterations.
struct Start {
    std::string name;
    Model model;
    State state;
    double time_step;
};

Start make_start(
    const std::string& name, const Model& model, DynamicSettings settings, long steps, double time_step) {
    DynamicAnalysis analysis(model, settings);
    REQUIRE(analysis.start().converged());
    for (long step = 0; step < steps; ++step) REQUIRE(analysis.advance().converged());
    return {name, model, analysis.state(), time_step};
}

std::vector<Start> make_starts(DynamicSettings settings) {
    settings.newton.tolerance = 1e-10;
    std::vector<Start> starts;
    settings.end_time = rubin2007::period;
    settings.steps = 100;
    starts.push_back(
        make_start("the paper's problem", rubin2007::make_model(), settings, 50, rubin2007::period / 30.0));
    settings.end_time = 5.0;  // steps of 0.05
    const Model flyer = make_free_flight(6);
    starts.push_back(make_start("rod in free flight", flyer, settings, 40, 0.3));
    return starts;
}

// The residual after 0, 1, 2 … iterations, down to round-off.
std::vector<double> measure_residuals(const Start& start,
                                      const DynamicSettings& settings,
                                      TangentKind tangent) {
    const System system(start.model);
    const auto integrator = make_integrator(settings);
    const double time = start.state.time;
    std::vector<double> residuals;
    for (int iterations = 0; iterations < 12; ++iterations) {
        State state = start.state;
        SolverWorkspace workspace(system, LinearSolverKind::klu);
        NewtonSettings newton;
        newton.tolerance = 1e-300;
        newton.max_iterations = iterations;
        newton.tangent = tangent;
        const Stage stage{0, time, start.time_step, time + start.time_step};
        residuals.push_back(
            solve_equilibrium({system, *integrator, newton}, stage, workspace, state).residual);
        if (residuals.back() < 1e-11) break;
    }
    return residuals;
}

// log(r₃/r₂)/log(r₂/r₁) of the last three residuals above round-off.
double compute_order(const std::vector<double>& residuals) {
    std::size_t last = residuals.size() - 1;
    while (residuals[last] < 1e-11) --last;
    REQUIRE(last >= 2);
    return std::log(residuals[last] / residuals[last - 1]) /
           std::log(residuals[last - 1] / residuals[last - 2]);
}

std::string print(const std::vector<double>& residuals) {
    std::string text;
    for (const double residual : residuals) text += Catch::StringMaker<double>::convert(residual) + " ";
    return text;
}

struct Iterations {
    double mean;
    int worst;
};

// Scheme (S) on the paper's problem, until no residual component is above 1e-10 H₀.
Iterations count_iterations(TangentKind tangent, long steps) {
    DynamicSettings settings = make_settings(Scheme::newmark_simplified, rubin2007::period, steps);
    settings.newton.absolute_residual = 1e-10 * rubin2007::momentum_scale;
    settings.newton.tangent = tangent;
    Iterations count{0.0, 0};
    run(rubin2007::make_model(), settings, [&](const DynamicAnalysis& analysis) {
        const int iterations = analysis.solver_row().newton_iterations;
        count.mean += static_cast<double>(iterations) / static_cast<double>(steps);
        count.worst = std::max(count.worst, iterations);
    });
    return count;
}

}  // namespace

TEST_CASE("Newton's method converges quadratically with the consistent tangent", "[solvers]") {
    for (const SchemeSample& scheme : all_schemes()) {
        // β = 1/6 is only conditionally stable, and the rod's step is too long for it.
        if (scheme.is_coupled()) continue;
        if (scheme.settings.scheme == Scheme::runge_kutta_4 || scheme.settings.beta < 0.25) continue;
        for (const Start& start : make_starts(scheme.settings)) {
            const auto residuals = measure_residuals(start, scheme.settings, TangentKind::consistent);
            INFO(scheme.name << ", " << start.name << ": " << print(residuals));
            CHECK(residuals.back() < 1e-11);
            CHECK(residuals.size() <= 6);
            CHECK(compute_order(residuals) > 1.75);
        }
    }
}

TEST_CASE("Newton's method converges quadratically with the mixed tangent", "[solvers][mixed]") {
    for (const SchemeSample& scheme : all_schemes()) {
        if (scheme.is_coupled()) continue;
        if (scheme.settings.scheme == Scheme::runge_kutta_4 || scheme.settings.beta < 0.25) continue;
        for (const Start& start : make_starts(scheme.settings)) {
            const auto residuals = measure_residuals(start, scheme.settings, TangentKind::mixed);
            INFO(scheme.name << ", " << start.name << ": " << print(residuals));
            CHECK(residuals.back() < 1e-11);
            CHECK(residuals.size() <= 6);
            CHECK(compute_order(residuals) > 1.75);
        }
    }
}

TEST_CASE("Newton's method converges linearly with the paper's tangent", "[solvers]") {
    const SchemeSample& scheme = all_schemes().front();
    const Start start = make_starts(scheme.settings).front();
    const auto residuals = measure_residuals(start, scheme.settings, TangentKind::paper);
    INFO(print(residuals));
    CHECK(residuals.size() == 12);
    CHECK(compute_order(residuals) == Approx(1.0).margin(0.1));
    CHECK(residuals[11] / residuals[10] == Approx(0.21).margin(0.02));
}

TEST_CASE("differences give the iterates of the consistent tangent", "[solvers]") {
    const SchemeSample& scheme = all_schemes().front();
    for (const Start& start : make_starts(scheme.settings)) {
        INFO(start.name);
        const auto consistent = measure_residuals(start, scheme.settings, TangentKind::consistent);
        const auto difference = measure_residuals(start, scheme.settings, TangentKind::difference);
        REQUIRE(consistent.size() == difference.size());
        for (std::size_t i = 0; i + 1 < consistent.size(); ++i) {
            CHECK(difference[i] == Approx(consistent[i]).epsilon(1e-3));
        }
    }
}

TEST_CASE("iterations on the paper's problem are those published with its reference", "[solvers]") {
    // Counted are linear solves from the predictor Δt ω + ½Δt² ω̇ until the largest component of the residual
    // is below 1e-10 H₀. (By its Euclidean norm the paper's tangent takes 2.29 at N = 400.)
    const Iterations exact_50 = count_iterations(TangentKind::consistent, 50);
    CHECK(exact_50.mean == Approx(2.64).epsilon(1e-12));
    CHECK(exact_50.worst == 3);
    const Iterations paper_50 = count_iterations(TangentKind::paper, 50);
    CHECK(paper_50.mean == Approx(4.92).epsilon(1e-12));
    CHECK(paper_50.worst == 8);
    CHECK(count_iterations(TangentKind::consistent, 400).mean == Approx(2.0).epsilon(1e-12));
    CHECK(count_iterations(TangentKind::paper, 400).mean == Approx(2.28).epsilon(1e-12));
    CHECK(count_iterations(TangentKind::difference, 50).mean == Approx(2.64).epsilon(1e-12));
}

TEST_CASE("free bodies and tops converge by their residual, not for want of a smaller increment",
          "[solvers]") {
    // One linear solve a step is enough at these step lengths.
    for (const auto& [model, end_time] : {std::pair(heavy_top::make_model(), 0.02),
                                          {make_free_body(Vec3(1.0, 1.0, 0.5), Vec3(0.5, 0.5, 1.0)), 1.0}}) {
        DynamicSettings settings = make_settings(Scheme::newmark_simplified, end_time, 200);
        settings.newton.tolerance = 1e-8;
        run(model, settings, [](const DynamicAnalysis& analysis) {
            if (analysis.state().time == 0.0) return;
            CHECK(analysis.solver_row().newton_iterations == 1);
            CHECK(analysis.solver_row().residual < 1e-8);
        });
    }
}

TEST_CASE("a tolerance below round-off is met as far as numbers go", "[solvers]") {
    for (const double tolerance : {1e-12, 1e-14, 0.0}) {
        DynamicSettings settings = make_settings(Scheme::newmark_simplified, rubin2007::period, 400);
        settings.newton.tolerance = tolerance;
        double worst = 0.0;
        run(rubin2007::make_model(), settings, [&](const DynamicAnalysis& analysis) {
            worst = std::max(worst, static_cast<double>(analysis.solver_row().newton_iterations));
        });
        CHECK(worst <= 4.0);
    }
}
