#include "solvers/equilibrium.hpp"

#include <limits>
#include <numbers>

#include "assembly/sample_model.hpp"
#include "integrators/scheme_samples.hpp"
#include "tools/catch.hpp"
#include "tools/difference.hpp"
#include "tools/tops.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

// One step of 0.1 from the model's initial state, with or without solving for initial accelerations.
struct Step {
    System system;
    SolverWorkspace workspace{system, LinearSolverKind::klu};
    State state = system.initial_state();
    NewtonSettings newton;
    DynamicSettings settings;

    explicit Step(const Model& model) : system(model) {}
    EquilibriumReport solve() {
        const auto integrator = make_integrator(settings);
        integrator->start(state);
        system.commit(state, 0.0);
        return solve_step({system, *integrator, newton}, {0, 0.0, 0.1, 0.1}, workspace, state);
    }
};

Model make_body_with_moment(double (*moment)(double)) {
    Model model = make_free_body(Vec3(1.0, 2.0, 3.0), Vec3::Zero());
    NodalLoad load;
    load.moment[1] = TimeFunction(moment);
    model.loads.push_back(load);
    return model;
}

double constant_moment(double) { return 5.0; }

constexpr TimeSpan any_step{0.0, 1.0};  // no support moves

}  // namespace

TEST_CASE("initial accelerations satisfy equilibrium", "[solvers]") {
    const Model model = make_sample_model();
    const System system(model);
    SolverWorkspace workspace(system, LinearSolverKind::klu);
    State state = make_sample_state(system, 7);
    for (NodeMotion& motion : state.trial) motion.a = motion.alpha = Vec3::Constant(9.0);
    const EquilibriumReport report = solve_accelerations(system, 0.4, any_step, workspace, state);
    CHECK(report.converged());
    CHECK(report.iterations == 1);
    Residual residual;
    system.compute_residual(state, 0.4, residual);
    const Eigen::VectorXd remainder = gather(residual.nodal, system.equations());
    CHECK(remainder.norm() < 1e-12 * residual.force_scale);
    CHECK(state.trial[0].a.isZero(0.0));  // the ball joint
    CHECK(state.trial[lone_node].alpha.head<2>().isZero(0.0));
}

TEST_CASE("a top's initial acceleration is its moment over the inertia about the pivot", "[solvers]") {
    // J = J_cm + m diag(1, 0, 1); M = (0, 1, 0) × m g.
    const Model model = heavy_top::make_model();
    const System system(model);
    SolverWorkspace workspace(system, LinearSolverKind::klu);
    State state = system.initial_state();
    REQUIRE(solve_accelerations(system, 0.0, any_step, workspace, state).converged());
    const Vec3 J(15.234375, 0.46875, 15.234375);
    const Vec3 omega(0.0, 150.0, -4.61538);
    const Vec3 moment = Vec3::UnitY().cross(15.0 * Vec3(0.0, 0.0, -9.81));
    const Vec3 expected = (moment - omega.cross(J.asDiagonal() * omega)).cwiseQuotient(J);
    CHECK(relative_difference(state.trial[0].alpha, expected) < 1e-14);
    CHECK(state.trial[0].a.isZero(0.0));
}

TEST_CASE("a step that converges says so", "[solvers]") {
    const Model model = make_body_with_moment(constant_moment);
    Step step(model);
    const EquilibriumReport report = step.solve();
    CHECK(report.converged());
    CHECK(report.iterations >= 1);
    CHECK(report.residual < 1e-8);
}

TEST_CASE("iterations of all stages are counted", "[solvers]") {
    const Model model = make_body_with_moment(constant_moment);
    Step step(model);
    step.settings.scheme = Scheme::sdirk_4;
    CHECK(step.solve().iterations >= 5);
    Step explicit_step(model);
    explicit_step.settings.scheme = Scheme::runge_kutta_4;
    CHECK(explicit_step.solve().iterations == 4);
    CHECK(explicit_step.workspace.stage_powers.size() == 4);
}

TEST_CASE("running out of iterations names the largest residual", "[solvers]") {
    const Model model = make_body_with_moment(constant_moment);
    Step step(model);
    step.newton.max_iterations = 0;
    const EquilibriumReport report = step.solve();
    CHECK(report.outcome == Outcome::out_of_iterations);
    CHECK(report.worst_node == 0);
    CHECK(report.worst_component == 4);
    CHECK(report.residual == Approx(1.0));
}

TEST_CASE("a tangent without inverse names the component", "[solvers]") {
    // No inertia about z.
    Model model = make_free_body(Vec3(1.0, 1.0, 0.0), Vec3::Zero());
    NodalLoad load;
    load.moment[0] = 1.0;
    model.loads.push_back(load);
    Step step(model);
    const EquilibriumReport report = step.solve();
    CHECK(report.outcome == Outcome::singular);
    CHECK(report.worst_node == 0);
    CHECK(report.worst_component == 5);
    SolverWorkspace workspace(step.system, LinearSolverKind::klu);
    State state = step.system.initial_state();
    const EquilibriumReport initial = solve_accelerations(step.system, 0.0, any_step, workspace, state);
    CHECK(initial.outcome == Outcome::singular);
    CHECK(initial.worst_component == 5);
}

TEST_CASE("a load that is not a number is found where it acts", "[solvers]") {
    for (const double value :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        Model model = make_free_body(Vec3(1.0, 2.0, 3.0), Vec3::Zero());
        NodalLoad load;
        load.force[2] = value;
        model.loads.push_back(load);
        for (const Scheme scheme : {Scheme::newmark_simplified, Scheme::runge_kutta_4}) {
            Step step(model);
            step.settings.scheme = scheme;
            const EquilibriumReport report = step.solve();
            CHECK(report.outcome == Outcome::not_finite);
            CHECK(report.worst_component == 2);
        }
    }
}

TEST_CASE("half a turn within a step is refused", "[solvers]") {
    const double just_below = 0.999 * std::numbers::pi / 0.1;
    const double just_above = 1.001 * std::numbers::pi / 0.1;
    for (const SchemeSample& scheme : all_schemes()) {
        if (scheme.settings.scheme == Scheme::runge_kutta_4) continue;
        INFO(scheme.name);
        const Model slow = make_free_body(Vec3(1.0, 2.0, 3.0), Vec3(0.0, just_below, 0.0));
        Step allowed(slow);
        allowed.settings = scheme.settings;
        CHECK(allowed.solve().converged());
        const Model fast = make_free_body(Vec3(1.0, 2.0, 3.0), Vec3(0.0, just_above, 0.0));
        Step refused(fast);
        refused.settings = scheme.settings;
        const EquilibriumReport report = refused.solve();
        CHECK(report.outcome == Outcome::rotation_too_large);
        CHECK(report.worst_node == 0);
    }
}

TEST_CASE("an absolute residual replaces the relative tolerance", "[solvers]") {
    const Model model = make_body_with_moment(constant_moment);
    Step loose(model);
    loose.newton.absolute_residual = 6.0;  // of a moment of 5 at the predictor
    CHECK(loose.solve().iterations == 0);
    Step tight(model);
    tight.newton.absolute_residual = 1e-11;
    CHECK(tight.solve().converged());
    CHECK(gather(tight.workspace.residual.nodal, tight.system.equations()).lpNorm<Eigen::Infinity>() <=
          1e-11);
}

TEST_CASE("a model without free components is in equilibrium", "[solvers]") {
    Model model = make_free_body(Vec3(1.0, 2.0, 3.0), Vec3(1.0, 0.0, 0.0));
    model.supports.push_back({0, {true, true, true, true, true, true}});
    Step step(model);
    CHECK(step.solve().converged());
    CHECK(step.state.trial[0].r.isZero(0.0));
    CHECK(step.state.trial[0].Lambda.isApprox(Quat::Identity(), 0.0));
}
