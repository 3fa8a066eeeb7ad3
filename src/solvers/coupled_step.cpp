#include "solvers/coupled_step.hpp"

#include <numbers>

#include "assembly/frame_columns.hpp"
#include "rotation/rotation_map.hpp"
#include "solvers/convergence_test.hpp"
#include "solvers/newton_steps.hpp"
#include "solvers/rotation_guard.hpp"
#include "state/increment.hpp"

namespace gxrod {

CoupledWorkspace::CoupledWorkspace(const System& system, LinearSolverKind kind)
    : complex_solver(kind, system.pattern(), system.team()) {}

namespace {

using Complex = std::complex<double>;

// y ← y + A x, with the values of A on the pattern.
void add_product(const SparsePattern& pattern,
                 const std::vector<double>& values,
                 const Eigen::VectorXd& x,
                 Eigen::VectorXd& y) {
    pattern.visit_entries([&](std::int64_t row, std::int64_t column, std::int64_t slot) {
        y[row] += values[static_cast<std::size_t>(slot)] * x[column];
    });
}

class CoupledNewton {
  public:
    CoupledNewton(const System& system,
                  const CoupledStages& scheme,
                  const NewtonSettings& settings,
                  const Stage& step,
                  SolverWorkspace& workspace,
                  State& state)
        : system_(system),
          team_(system.team()),
          scheme_(scheme),
          settings_(settings),
          step_(step),
          span_{step.step_time, step.time_step},
          request_{ConstraintLevel::position, span_},
          workspace_(workspace),
          own_(*workspace.coupled),
          state_(state),
          stage_reports_(count()),
          guards_(count(), RotationGuard(system)) {
        for (std::size_t j = 0; j < count(); ++j) tests_.emplace_back(system, settings);
        own_.residuals.resize(count());
    }

    EquilibriumReport solve() {
        predict();
        if (!check_predicted()) return report_;
        compute_residuals();
        compute_matrices();
        if (factorize_all()) iterate();
        if (!report_.converged() && !solve_exactly()) return report_;
        finish();
        return report_;
    }

  private:
    // With the matrices of the start. Stops too where the increments fall so slowly that iterations will not
    // suffice.
    void iterate() {
        while (!is_done()) {
            ++report_.iterations;
            if (!solve_increments() || !apply()) return;
            update_rates();
            compute_residuals();
            if (is_slow()) return;
        }
        if (!report_.converged() || report_.iterations == 0) return;
        // What is left falls by as much again, without a residual.
        if (solve_increments() && apply()) update_rates();
    }

    bool is_slow() {
        constexpr int patience = 3;
        constexpr double slow = 0.5;
        const bool is_first = report_.iterations < patience;
        if (is_first || largest_increment_ < slow * increment_before_ || report_.residual < 1e-6)
            return false;
        report_.outcome = Outcome::out_of_iterations;
        return true;
    }

    // From the prediction again, with the derivative of all equations by all stages.
    bool solve_exactly() {
        const int before = report_.iterations;
        report_ = EquilibriumReport{};
        start_over();
        while (!is_done()) {
            ++report_.iterations;
            if (!solve_stacked() || !apply()) break;
            update_rates();
            compute_residuals();
        }
        if (report_.converged()) report_.iterations += before;
        return report_.converged();
    }

    void start_over() {
        tests_.clear();
        for (std::size_t j = 0; j < count(); ++j) tests_.emplace_back(system_, settings_);
        guards_.assign(count(), RotationGuard(system_));
        stage_reports_.assign(count(), EquilibriumReport{});
        turns_axes_ = false;
        predict();
        compute_residuals();
    }

    // Sets increments_, in global axes.
    bool solve_stacked() {
        if (!own_.stacked) {
            own_.stacked = std::make_unique<StackedPattern>(system_.pattern(), scheme_.stage_count());
            own_.stacked_solver = make_general_solver(own_.stacked->pattern());
        }
        std::vector<double> values;
        Eigen::VectorXd right_side;
        stage_values_.resize(count());
        for (std::size_t j = 0; j < count(); ++j) {
            const PhaseTimer timer(workspace_.seconds.assembly);
            with_stage(j, [&] { assemble_row(j, values); });
            Eigen::VectorXd residual = gather(own_.residuals[j].nodal, system_.equations(), team_);
            if (!system_.joints().empty())
                system_.joints().set_rows(own_.residuals[j].rows, stage_values_[j], residual);
            own_.stacked->set(static_cast<int>(j), -residual, right_side);
        }
        const PhaseTimer timer(workspace_.seconds.solve);
        if (!own_.stacked_solver->factorize(values).regular) {
            report_.outcome = Outcome::singular;
            return false;
        }
        own_.stacked_solver->solve(right_side);
        increments_.resize(count());
        for (std::size_t j = 0; j < count(); ++j)
            own_.stacked->get(static_cast<int>(j), right_side, increments_[j]);
        return check_increments();
    }

    // The equations of stage j, which is the trial: by its own placements, then by those of the others.
    void assemble_row(std::size_t j, std::vector<double>& values) {
        for (std::size_t other = 0; other < count(); ++other) {
            const std::size_t k = (j + other) % count();
            std::vector<double>& block = k == j ? stage_values_[j] : own_.real;
            state_.stage_motions[j].swap(state_.trial);  // the scheme needs all stages
            scheme_.linearize(state_,
                              step_.time_step,
                              static_cast<int>(j),
                              static_cast<int>(k),
                              workspace_.linearizations,
                              team_);
            state_.stage_motions[j].swap(state_.trial);
            system_.compute_tangent(state_, time_of(j), workspace_.linearizations, block, request_);
            own_.stacked->set(static_cast<int>(j), static_cast<int>(k), block, 1.0, values);
        }
    }

    // Of the increments that is not finite, reported.
    bool check_increments() {
        for (const Eigen::VectorXd& increment : increments_) {
            if (increment.allFinite()) continue;
            report_.outcome = Outcome::not_finite;
            report_.worst_node = report_.worst_component = -1;
            return false;
        }
        return true;
    }

    std::size_t count() const { return static_cast<std::size_t>(scheme_.stage_count()); }
    double time_of(std::size_t j) const {
        Stage stage = step_;
        stage.index = static_cast<int>(j);
        return scheme_.stage_time(stage);
    }

    // Makes a stage the trial while work() is called.
    template <class Work>
    void with_stage(std::size_t j, const Work& work) {
        const auto exchange = [&] {
            state_.trial.swap(state_.stage_motions[j]);
            state_.joints_trial.swap(state_.stage_joints[j]);
        };
        exchange();
        state_.trial_time = time_of(j);
        try {
            work();
        } catch (...) {
            exchange();
            throw;
        }
        exchange();
    }

    void predict() {
        const PhaseTimer timer(workspace_.seconds.update);
        scheme_.predict(state_, step_, team_);
        state_.stage_joints.assign(count(), state_.joints_previous);
        for (std::size_t j = 0; j < count(); ++j)
            with_stage(j, [&] { system_.supports().place(time_of(j), state_); });
        update_rates();
    }

    void update_rates() {
        const PhaseTimer timer(workspace_.seconds.update);
        scheme_.update_stages(state_, step_, team_);
        for (std::size_t j = 0; j < count(); ++j)
            system_.supports().set_rates(time_of(j), span_, state_.stage_motions[j]);
    }

    bool check_predicted() {
        for (std::size_t j = 0; j < count(); ++j) {
            const std::vector<NodeMotion>& motions = state_.stage_motions[j];
            const auto predicted = [&](std::size_t node) { return motions[node].theta; };
            if (!guards_[j].admits(state_.previous, predicted, report_) || !check_rotations(motions))
                return false;
        }
        return true;
    }

    // At the start of the step, where the motion is known.
    void compute_matrices() {
        const PhaseTimer timer(workspace_.seconds.assembly);
        state_.trial = state_.previous;
        state_.joints_trial = state_.joints_previous;
        state_.trial_time = step_.step_time;
        const auto compute = [&](const NodeLinearization& one, std::vector<double>& values) {
            workspace_.linearizations.assign(state_.trial.size(), one);
            system_.compute_tangent(state_, step_.step_time, workspace_.linearizations, values, request_);
        };
        const double factor = scheme_.typical_factor() / step_.time_step;
        const Mat3 I = Mat3::Identity();
        compute({1.0, factor, factor * factor, factor * I, factor * factor * I}, workspace_.values);
        compute({.rate = 1.0, .d_omega = I}, own_.damping);
        compute({.acceleration = 1.0, .d_alpha = I}, own_.mass);
    }

    // With S(λ) = K + λ/Δt C + (λ/Δt)² M: that of the typical factor is known, joints included.
    bool factorize_all() {
        if (scheme_.real_factor() > 0.0 && !factorize(system_, workspace_, report_)) return false;
        const PhaseTimer timer(workspace_.seconds.solve);
        const double known = scheme_.typical_factor() / step_.time_step;
        const Complex factor = scheme_.complex_factor() / step_.time_step;
        const Complex of_damping = factor - known;
        const Complex of_mass = factor * factor - known * known;
        own_.real.resize(workspace_.values.size());
        own_.imaginary.resize(workspace_.values.size());
        for (std::size_t i = 0; i < own_.real.size(); ++i) {
            const Complex added = of_damping * own_.damping[i] + of_mass * own_.mass[i];
            own_.real[i] = workspace_.values[i] + added.real();
            own_.imaginary[i] = added.imag();
        }
        // Between K, at the angle 0, and λ² M.
        const double half_angle = std::arg(scheme_.complex_factor());
        own_.factors.setConstant(system_.equations().count(), std::polar(1.0, -half_angle));
        turn_joints(half_angle);
        const Factorization factorization =
            own_.complex_solver.factorize(own_.real, own_.imaginary, own_.factors);
        if (factorization.regular) return true;
        report_.outcome = Outcome::singular;
        return false;
    }

    // The equations of joints the other way, so that what elimination leaves of them is definite.
    void turn_joints(double half_angle) {
        if (system_.joints().empty()) return;
        const std::vector<AttachedUnknowns>& attached = system_.joints().attached();
        for (std::size_t i = 0; i < attached.size(); ++i)
            own_.factors.segment(system_.equations().of_attached(i), attached[i].count)
                .setConstant(std::polar(1.0, half_angle));
    }

    void compute_residuals() {
        const PhaseTimer timer(workspace_.seconds.assembly);
        report_.residual = 0.0;
        for (std::size_t j = 0; j < count(); ++j) {
            EquilibriumReport& report = stage_reports_[j];
            report.iterations = report_.iterations;
            with_stage(j, [&] {
                system_.compute_residual(state_, time_of(j), own_.residuals[j], request_);
                tests_[j].measure(own_.residuals[j], report);
                if (!system_.joints().empty())
                    report.joint_gap = system_.joints().measure_gap(own_.residuals[j].rows, state_);
            });
            const bool is_worse = !(report.residual <= report_.residual);
            if (report.joint_gap.size >= report_.joint_gap.size) report_.joint_gap = report.joint_gap;
            if (!is_worse || report_.outcome == Outcome::not_finite) continue;
            report_.outcome = report.outcome;
            report_.residual = report.residual;
            report_.worst_node = report.worst_node;
            report_.worst_component = report.worst_component;
        }
    }

    bool is_done() {
        if (report_.outcome == Outcome::not_finite) return true;
        bool all_met = true;
        for (std::size_t j = 0; j < count(); ++j)
            all_met = all_met && tests_[j].is_met(own_.residuals[j], stage_reports_[j]);
        if (all_met) return true;
        if (report_.iterations < settings_.max_iterations) return false;
        report_.outcome = Outcome::out_of_iterations;
        return true;
    }

    // How a node's displacements and spins have turned in a stage; a support's axes do not.
    Mat3 turn_of(std::size_t j, std::size_t node, int first) const {
        const HeldComponents& held = system_.supports().held(static_cast<int>(node));
        for (int i = first; i < first + 3; ++i) {
            if (held[static_cast<std::size_t>(i)]) return Mat3::Identity();
        }
        return exp_matrix(state_.stage_motions[j][node].theta);
    }
    template <class Turn>
    void turn_all(std::size_t j, std::vector<Vec6>& vectors, const Turn& turn) const {
        team_.for_each_range(vectors.size(), [&](std::size_t first, std::size_t last) {
            for (std::size_t node = first; node < last; ++node) {
                for (int part = 0; part < 6; part += 3) {
                    const Vec3 turned = turn(turn_of(j, node, part), vectors[node].segment<3>(part));
                    vectors[node].segment<3>(part) = turned;
                }
            }
        });
    }

    // Sets increments_ to those of all equations, in the axes of the start.
    bool solve_increments() {
        std::vector<Eigen::VectorXd> right_sides(count());
        for (std::size_t j = 0; j < count(); ++j) {
            std::vector<Vec6>& nodal = workspace_.increments;
            nodal = own_.residuals[j].nodal;
            turn_all(j, nodal, [](const Mat3& Q, const Vec3& x) -> Vec3 { return Q.transpose() * x; });
            right_sides[j] = gather(nodal, system_.equations(), team_);
            if (!system_.joints().empty())
                system_.joints().set_rows(own_.residuals[j].rows, workspace_.values, right_sides[j]);
        }
        const PhaseTimer timer(workspace_.seconds.solve);
        const Eigen::Index size = right_sides[0].size();
        Eigen::VectorXd real = Eigen::VectorXd::Zero(size);
        Eigen::VectorXcd complex = Eigen::VectorXcd::Zero(size);
        for (std::size_t j = 0; j < count(); ++j) {
            real -= scheme_.to_real()[static_cast<Eigen::Index>(j)] * right_sides[j];
            complex -= scheme_.to_complex()[static_cast<Eigen::Index>(j)] * right_sides[j];
        }
        if (scheme_.real_factor() > 0.0) workspace_.linear_solver->solve(real);
        own_.complex_solver.solve(complex);
        increments_.resize(count());
        for (std::size_t j = 0; j < count(); ++j) {
            const auto index = static_cast<Eigen::Index>(j);
            increments_[j] =
                scheme_.from_real()[index] * real + 2.0 * (scheme_.from_complex()[index] * complex).real();
        }
        return check_increments();
    }

    // False, and so reported, if an increment turns too far.
    bool apply() {
        const PhaseTimer timer(workspace_.seconds.update);
        std::vector<Vec6>& deltas = workspace_.increments;
        deltas.resize(state_.trial.size());
        increment_before_ = largest_increment_;
        largest_increment_ = 0.0;
        for (std::size_t j = 0; j < count(); ++j) {
            for (std::size_t node = 0; node < deltas.size(); ++node)
                deltas[node] = system_.equations().increment_of(static_cast<int>(node), increments_[j]);
            if (turns_axes_) turn_all(j, deltas, [](const Mat3& Q, const Vec3& x) -> Vec3 { return Q * x; });
            bool is_admitted = true;
            with_stage(j, [&] {
                tests_[j].add_increment(deltas, state_);
                largest_increment_ = std::max(largest_increment_, tests_[j].last_increment());
                const auto spin = [&](std::size_t node) -> Vec3 { return deltas[node].tail<3>(); };
                is_admitted = guards_[j].admits(state_.trial, spin, report_);
                if (!is_admitted) return;
                if (!system_.joints().empty())
                    system_.joints().advance_multipliers(
                        deltas, increments_[j], turns_axes_ ? workspace_.values : stage_values_[j], state_);
                for (std::size_t node = 0; node < deltas.size(); ++node)
                    apply_spin(state_.previous[node],
                               deltas[node].head<3>(),
                               deltas[node].tail<3>(),
                               state_.trial[node]);
            });
            if (!is_admitted || !check_rotations(state_.stage_motions[j])) return false;
        }
        return true;
    }

    // False, and so reported, if a node turned by π or more since the last accepted step.
    bool check_rotations(const std::vector<NodeMotion>& motions) {
        const auto angle = [&](std::size_t node) { return motions[node].theta.norm(); };
        if (team_.find_largest(motions.size(), angle) < std::numbers::pi) return true;
        std::size_t node = 0;
        while (angle(node) < std::numbers::pi) ++node;
        report_.outcome = Outcome::rotation_too_large;
        report_.worst_node = static_cast<int>(node);
        report_.worst_component = -1;
        return false;
    }

    void finish() {
        workspace_.stage_powers.clear();
        for (std::size_t j = 0; j < count(); ++j) {
            with_stage(j, [&] {
                workspace_.stage_powers.push_back(
                    compute_power(system_, state_, time_of(j), own_.residuals[j], span_));
            });
        }
        if (scheme_.error_order() > 0) estimate_error();
        scheme_.end_step(state_, step_, team_);
        state_.joints_trial = state_.stage_joints.back();
        workspace_.residual = own_.residuals.back();
    }

    // (R6): S(λ) e_r = M (q + λ/Δt p) + C p, e_v = λ/Δt e_r − p.
    void estimate_error() {
        const std::size_t nodes = state_.previous.size();
        const double factor = scheme_.real_factor() / step_.time_step;
        std::vector<Vec6>& p = own_.rate_errors;
        std::vector<Vec6>& both = own_.placement_errors;
        p.resize(nodes);
        both.resize(nodes);
        for (std::size_t node = 0; node < nodes; ++node) {
            const CoupledStages::Defect defect = scheme_.compute_defect(state_, step_.time_step, node);
            p[node] = defect.rates;
            both[node] = defect.accelerations + factor * defect.rates;
        }
        Eigen::VectorXd vector = Eigen::VectorXd::Zero(system_.equations().count());
        add_product(system_.pattern(), own_.mass, gather(both, system_.equations(), team_), vector);
        add_product(system_.pattern(), own_.damping, gather(p, system_.equations(), team_), vector);
        workspace_.linear_solver->solve(vector);
        for (std::size_t node = 0; node < nodes; ++node) {
            const Vec6 error = system_.equations().increment_of(static_cast<int>(node), vector);
            both[node] = error;
            p[node] = step_.time_step * (factor * error - p[node]);
        }
    }

    const System& system_;
    const ThreadTeam& team_;
    const CoupledStages& scheme_;
    const NewtonSettings& settings_;
    const Stage& step_;
    TimeSpan span_;
    ConstraintRequest request_;
    SolverWorkspace& workspace_;
    CoupledWorkspace& own_;
    State& state_;
    EquilibriumReport report_;
    std::vector<EquilibriumReport> stage_reports_;
    std::vector<ConvergenceTest> tests_;
    std::vector<RotationGuard> guards_;
    std::vector<Eigen::VectorXd> increments_;        // of each stage
    std::vector<std::vector<double>> stage_values_;  // of the exact matrix, its blocks on the diagonal
    bool turns_axes_ = true;                         // with the nodes, from stage to stage
    double largest_increment_ = 0.0, increment_before_ = 0.0;
};

}  // namespace

EquilibriumReport solve_coupled_step(const System& system,
                                     const CoupledStages& scheme,
                                     const NewtonSettings& settings,
                                     const Stage& step,
                                     SolverWorkspace& workspace,
                                     State& state) {
    if (!workspace.coupled)
        workspace.coupled = std::make_unique<CoupledWorkspace>(system, workspace.linear_solver->kind());
    return CoupledNewton(system, scheme, settings, step, workspace, state).solve();
}

}  // namespace gxrod
