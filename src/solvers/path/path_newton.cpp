#include "solvers/path/path_newton.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "assembly/contact/contact_limits.hpp"
#include "assembly/contact/contacts.hpp"
#include "assembly/contact/step_limiter.hpp"
#include "solvers/convergence_test.hpp"
#include "solvers/newton_steps.hpp"
#include "solvers/paired_matrix.hpp"
#include "solvers/path/path_tangent.hpp"
#include "solvers/rotation_guard.hpp"
#include "solvers/trial_moves.hpp"
#include "state/increment.hpp"

namespace gxrod {

namespace {

// The members are what the iterations share.
class PathNewton {
  public:
    PathNewton(const SolverSetup& setup,
               const PathProblem& problem,
               SolverWorkspace& workspace,
               State& state,
               PathSolution& solution)
        : system_(setup.system),
          integrator_(setup.integrator),
          settings_(setup.settings),
          problem_(problem),
          workspace_(workspace),
          state_(state),
          solution_(solution),
          limiter_(system_),
          may_touch_(Contacts(system_).are_possible()),
          convergence_(system_, settings_),
          guard_(system_) {}

    EquilibriumReport solve() {
        start();
        const auto count = static_cast<Eigen::Index>(problem_.amplitude_count());
        if (!apply(problem_.prediction, Eigen::VectorXd::Zero(count))) return report_;
        compute_residual();
        while (!is_done()) {
            compute_tangent();
            if (!factorize(system_, workspace_, report_)) break;
            ++report_.iterations;
            if (!solve_increment() || !apply(increment_, amplitudes_)) break;
            compute_residual();
        }
        // The forces are those of the law from here on.
        if (report_.converged()) state_.contact.has_parameters = false;
        return report_;
    }

  private:
    const Stage stage() const { return {0, state_.time, 0.0, solution_.load_factor}; }

    void start() {
        const PhaseTimer timer(workspace_.seconds.update);
        solution_.load_factor = state_.time;
        solution_.amplitudes.setZero(static_cast<Eigen::Index>(problem_.amplitude_count()));
        integrator_.begin_stage(state_, stage(), system_.team());
        state_.resultants.clear();
        if (settings_.tangent == TangentKind::mixed) system_.start_resultants(state_);
        const auto size = static_cast<Eigen::Index>(problem_.rows.size());
        owed_.setZero(size);
        for (Eigen::Index i = 0; may_touch_ && i < size; ++i) {
            const PathVector& row = problem_.rows[static_cast<std::size_t>(i)];
            owed_[i] = row.u.dot(problem_.prediction.u) + row.load * problem_.prediction.load;
        }
    }

    void compute_residual() {
        const PhaseTimer timer(workspace_.seconds.assembly);
        state_.trial_time = solution_.load_factor;
        system_.compute_residual(state_, solution_.load_factor, workspace_.residual);
        for (std::size_t i = 0; i < problem_.disturbances.size(); ++i) {
            const Eigen::VectorXd force =
                solution_.amplitudes[static_cast<Eigen::Index>(i)] * problem_.disturbances[i];
            for (std::size_t node = 0; node < workspace_.residual.nodal.size(); ++node) {
                workspace_.residual.nodal[node] +=
                    system_.equations().increment_of(static_cast<int>(node), force);
            }
        }
        convergence_.measure(workspace_.residual, report_);
        if (!system_.joints().empty())
            report_.joint_gap = system_.joints().measure_gap(workspace_.residual.rows, state_);
    }

    // At least one tangent is needed, for the direction of the path.
    bool is_done() {
        if (report_.outcome == Outcome::not_finite) return true;
        if (report_.iterations > 0 && owed_.isZero(0.0) && convergence_.is_met(workspace_.residual, report_))
            return true;
        if (report_.iterations < settings_.max_iterations) return false;
        report_.outcome = Outcome::out_of_iterations;
        return true;
    }

    void compute_tangent() {
        const PhaseTimer timer(workspace_.seconds.assembly);
        integrator_.linearize(state_, stage(), workspace_.linearizations, system_.team());
        compute_tangent_on_path(system_, solution_.load_factor, state_, workspace_);
    }

    Borders make_borders() const {
        const Eigen::Index size = static_cast<Eigen::Index>(problem_.rows.size());
        const Eigen::Index count = system_.equations().count();
        Borders borders{
            Eigen::MatrixXd(count, size), Eigen::MatrixXd(count, size), Eigen::MatrixXd::Zero(size, size)};
        borders.columns.col(0) =
            compute_load_gradient(system_, solution_.load_factor, workspace_.values, state_);
        for (std::size_t i = 0; i < problem_.disturbances.size(); ++i)
            borders.columns.col(static_cast<Eigen::Index>(i) + 1) = problem_.disturbances[i];
        if (problem_.other_factor != nullptr)
            borders.columns.col(size - 1) = compute_other_gradient(
                system_, *problem_.other_factor, solution_.load_factor, workspace_.values, state_);
        for (Eigen::Index i = 0; i < size; ++i) {
            borders.rows.col(i) = problem_.rows[static_cast<std::size_t>(i)].u;
            borders.corner(i, 0) = problem_.rows[static_cast<std::size_t>(i)].load;
        }
        return borders;
    }

    bool solve_increment() {
        const PhaseTimer timer(workspace_.seconds.solve);
        const FactorizedTangent tangent = factorized_tangent(system_, workspace_);
        const BorderedSolve bordered(tangent.solver, tangent.pattern, tangent.values, make_borders());
        const Eigen::Index size = static_cast<Eigen::Index>(problem_.rows.size());
        limiter_.replace_by_tangent_forces(state_, solution_.load_factor, 1.0, workspace_.residual);
        const BorderedVector solved =
            bordered.solve({-gather_residual(system_, workspace_.residual, workspace_.values), owed_});
        increment_ = {solved.x, solved.y[0]};
        amplitudes_ = solved.y.tail(size - 1);
        solution_.direction = {-bordered.solved_columns().col(0), 1.0};
        if (solved.x.allFinite() && solved.y.allFinite()) return true;
        report_.outcome = Outcome::not_finite;
        report_.worst_node = report_.worst_component = -1;
        return false;
    }

    // False, and so reported, if the increment turns too far.
    bool apply(const PathVector& whole, const Eigen::VectorXd& whole_amplitudes) {
        const PhaseTimer timer(workspace_.seconds.update);
        const bool is_prediction = report_.iterations == 0;
        const double part = may_touch_ ? find_free_part(whole, is_prediction) : 1.0;
        const PathVector increment = part < 1.0 ? part * whole : whole;
        const Eigen::VectorXd amplitudes = part * whole_amplitudes;
        owed_ *= 1.0 - part;
        solution_.load_factor += increment.load;
        state_.trial_time = solution_.load_factor;
        solution_.amplitudes += amplitudes;
        if (problem_.other_factor != nullptr) {
            *problem_.other_factor += amplitudes[amplitudes.size() - 1];
            system_.forget_loads();
        }
        std::vector<Vec6>& deltas = workspace_.increments;
        deltas.resize(state_.trial.size());
        for (std::size_t node = 0; node < deltas.size(); ++node)
            deltas[node] = system_.equations().increment_of(static_cast<int>(node), increment.u);
        convergence_.add_increment(deltas, state_);
        const bool moves_supports = system_.supports().move();
        std::vector<Vec6> with_supports;
        if (moves_supports) {
            with_supports = deltas;
            add_support_motion(system_, solution_.load_factor, state_, with_supports);
        }
        if (!admit(moves_supports ? with_supports : deltas)) return false;
        // The prediction leaves multipliers as they are.
        if (!system_.joints().empty() && report_.iterations > 0) {
            system_.joints().advance_multipliers(
                moves_supports ? with_supports : deltas, increment.u, workspace_.values, state_);
        }
        for (std::size_t node = 0; node < deltas.size(); ++node) {
            apply_spin(
                state_.previous[node], deltas[node].head<3>(), deltas[node].tail<3>(), state_.trial[node]);
        }
        if (moves_supports) system_.supports().place(solution_.load_factor, state_);
        if (may_touch_ && is_prediction) start_contact();
        return check_step_rotations();
    }

    // Finds the part of an increment of the path, of supports that move too, in which no gap closes.
    double find_free_part(const PathVector& whole, bool is_prediction) {
        std::vector<Vec6> deltas(state_.trial.size());
        for (std::size_t node = 0; node < deltas.size(); ++node)
            deltas[node] = system_.equations().increment_of(static_cast<int>(node), whole.u);
        const double load_factor = solution_.load_factor + whole.load;
        if (system_.supports().move()) add_support_motion(system_, load_factor, state_, deltas);
        const ContactLimits limits = is_prediction
                                         ? limiter_.limit_common_prediction(deltas, state_, load_factor)
                                         : limiter_.limit_common_increment(deltas, state_, load_factor);
        report_.least_gap = std::min(report_.least_gap, limits.least_gap);
        if (limits.shorten()) ++report_.shortened;
        return limits.least;
    }

    void start_contact() {
        limiter_.start_forces(state_, solution_.load_factor);
        if (workspace_.paired) workspace_.paired->start(Contacts(system_).list_groups(state_));
    }

    bool admit(const std::vector<Vec6>& deltas) {
        const auto spin = [&](std::size_t node) -> Vec3 { return deltas[node].tail<3>(); };
        if (!guard_.admits(state_.trial, spin, report_)) return false;
        if (settings_.tangent == TangentKind::mixed) system_.advance_resultants(deltas, state_);
        return true;
    }

    // False, and so reported, if a node whose step rotations are interpolated turned by π or more.
    bool check_step_rotations() {
        if (!system_.traits().uses_step_rotations) return true;
        for (std::size_t node = 0; node < state_.trial.size(); ++node) {
            if (state_.trial[node].theta.norm() < std::numbers::pi) continue;
            report_.outcome = Outcome::rotation_too_large;
            report_.worst_node = static_cast<int>(node);
            report_.worst_component = -1;
            return false;
        }
        return true;
    }

    const System& system_;
    const Integrator& integrator_;
    const NewtonSettings& settings_;
    const PathProblem& problem_;
    SolverWorkspace& workspace_;
    State& state_;
    PathSolution& solution_;
    EquilibriumReport report_;
    PathVector increment_;
    Eigen::VectorXd amplitudes_;
    Eigen::VectorXd owed_;  // what increments along the rows still have to add to the prediction's
    StepLimiter limiter_;
    bool may_touch_;
    ConvergenceTest convergence_;
    RotationGuard guard_;
};

}  // namespace

namespace {

constexpr double gradient_difference = 1e-5;

// How the residual of the trial motions changes where only what acts on them changes, over the difference.
// Supports stay where they are.
Eigen::VectorXd compare_residuals(const System& system,
                                  const Residual& here,
                                  Residual there,
                                  const std::vector<double>& values) {
    for (std::size_t i = 0; i < here.nodal.size(); ++i)
        there.nodal[i] = (there.nodal[i] - here.nodal[i]) / gradient_difference;
    for (std::size_t i = 0; i < here.rows.size(); ++i)
        there.rows[i] = (there.rows[i] - here.rows[i]) / gradient_difference;
    return gather_residual(system, there, values);
}

// ∂R/∂t of supports that move, from where they are at a load factor that is further by the difference. Stiff
// elements answer nonlinearly even to that; so by a part of it, to both sides.
Eigen::VectorXd compute_support_gradient(const System& system,
                                         double time_of_move,
                                         double time_of_loads,
                                         const Residual& residual,
                                         const std::vector<double>& values,
                                         const State& state) {
    constexpr double part = 0.1;
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(system.equations().count());
    for (const double side : {part, -part})
        sum +=
            compute_support_motion_force(system, time_of_move, time_of_loads, side, residual, values, state);
    return 0.5 / gradient_difference * sum;
}

}  // namespace

Eigen::VectorXd compute_load_gradient(const System& system,
                                      double load_factor,
                                      const std::vector<double>& values,
                                      const State& state) {
    // The difference is exact for what grows with the load factor.
    const double further = load_factor + gradient_difference;
    Residual here, there;
    system.compute_residual(state, load_factor, here);
    system.compute_residual(state, further, there);
    Eigen::VectorXd result = compare_residuals(system, here, std::move(there), values);
    if (!system.supports().move()) return result;
    return result + compute_support_gradient(system, further, load_factor, here, values, state);
}

Eigen::VectorXd compute_other_gradient(const System& system,
                                       double& other_factor,
                                       double load_factor,
                                       const std::vector<double>& values,
                                       const State& state) {
    Residual here, there;
    system.compute_residual(state, load_factor, here);
    const double kept = other_factor;
    other_factor = kept + gradient_difference;
    system.forget_loads();
    system.compute_residual(state, load_factor, there);
    // Supports move from where they are in loads that have changed already.
    Eigen::VectorXd moved;
    if (system.supports().move())
        moved = compute_support_gradient(system, load_factor, load_factor, there, values, state);
    Eigen::VectorXd result = compare_residuals(system, here, std::move(there), values);
    if (moved.size() > 0) result += moved;
    other_factor = kept;
    system.forget_loads();
    return result;
}

EquilibriumReport solve_path_equilibrium(const SolverSetup& setup,
                                         const PathProblem& problem,
                                         SolverWorkspace& workspace,
                                         State& state,
                                         PathSolution& solution) {
    const double other_factor = problem.other_factor != nullptr ? *problem.other_factor : 0.0;
    const EquilibriumReport first = PathNewton(setup, problem, workspace, state, solution).solve();
    if (first.converged() || setup.settings.tangent != TangentKind::mixed) return first;
    if (problem.other_factor != nullptr) *problem.other_factor = other_factor;
    NewtonSettings other = setup.settings;
    other.tangent = TangentKind::consistent;
    EquilibriumReport report =
        PathNewton({setup.system, setup.integrator, other}, problem, workspace, state, solution).solve();
    report.iterations += first.iterations;
    return report;
}

}  // namespace gxrod
