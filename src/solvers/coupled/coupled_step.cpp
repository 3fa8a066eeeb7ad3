#include "solvers/coupled/coupled_step.hpp"

#include <algorithm>

#include "assembly/contact/contact_limits.hpp"
#include "assembly/contact/contacts.hpp"
#include "assembly/contact/step_limiter.hpp"
#include "solvers/convergence_test.hpp"
#include "solvers/rotation_guard.hpp"
#include "solvers/trial_moves.hpp"
#include "state/increment.hpp"

namespace gxrod {

namespace {

using Prediction = CoupledStages::Prediction;

class CoupledNewton {
  public:
    CoupledNewton(const StagesOfStep& stages, const NewtonSettings& settings, SolverWorkspace& workspace)
        : stages_(stages),
          system_(stages.system),
          state_(stages.state),
          settings_(settings),
          workspace_(workspace),
          own_(*workspace.coupled),
          contacts_(system_),
          limiter_(system_) {
        own_.residuals.resize(stages_.count());
    }

    EquilibriumReport solve() {
        begin(Prediction::from_last_step);
        if (!check_predicted()) {
            report_ = EquilibriumReport{};
            begin(Prediction::from_start);
            if (!check_predicted()) return report_;
        }
        compute_residuals();
        if (own_.common.factorize(stages_, workspace_, report_)) iterate_with_common();
        if (!report_.converged() && (system_.joints().empty() || stages_.asks_for_positions))
            iterate_with_exact();
        if (report_.converged()) finish();
        return report_;
    }

  private:
    // From the prediction.
    void begin(Prediction prediction) {
        const PhaseTimer timer(workspace_.seconds.update);
        tests_.clear();
        for (std::size_t j = 0; j < stages_.count(); ++j)
            tests_.emplace_back(system_, settings_, stages_.request().level);
        guards_.assign(stages_.count(), RotationGuard(system_));
        stage_reports_.assign(stages_.count(), EquilibriumReport{});
        stages_.scheme.predict(state_, stages_.step, prediction, system_.team());
        state_.stage_joints.assign(stages_.count(), state_.joints_previous);
        for (std::size_t j = 0; j < stages_.count(); ++j)
            stages_.with_stage(j, [&] { system_.supports().place(stages_.time_of(j), state_); });
        if (contacts_.are_possible()) limit_predictions();
        update_rates();
    }

    // Takes the prediction of each stage as far as nothing touches, and moved supports to their places.
    void limit_predictions() {
        own_.contacts.assign(stages_.count(), ContactTrial{});
        are_blocked_ = false;
        for (std::size_t j = 0; j < stages_.count(); ++j) {
            stages_.with_stage(j, [&] {
                const double time = stages_.time_of(j);
                if (!limiter_.limit_prediction(state_, time).shorten()) return;
                ++report_.shortened;
                if (!system_.supports().move()) return;
                std::vector<Vec6> deltas(state_.trial.size(), Vec6::Zero());
                add_support_motion(system_, time, state_, deltas);
                if (limiter_.limit_increment(deltas, state_, time).shorten()) are_blocked_ = true;
                system_.supports().place(time, state_);
                limiter_.start_forces(state_, time);
            });
        }
    }

    // Whether rods or bodies touch anything at a stage, or would.
    bool touch() {
        if (!contacts_.are_possible()) return false;
        bool touches = report_.shortened > 0;
        for (std::size_t j = 0; j < stages_.count() && !touches; ++j)
            stages_.with_stage(j, [&] { touches = contacts_.have_forces(state_, stages_.time_of(j)); });
        return touches;
    }

    void iterate_with_common() {
        // The matrix has no blocks of rods that touch each other, and nothing that only comes to touch.
        if (report_.shortened > 0 || (contacts_.couple_rods() && touch())) {
            report_.outcome = Outcome::out_of_iterations;
            return;
        }
        while (!is_done()) {
            ++report_.iterations;
            if (!move_by_common()) return;
            compute_residuals();
            if (is_slow(0.5) || report_.shortened > 0) {
                report_.outcome = Outcome::out_of_iterations;
                return;
            }
        }
        // What is left falls by as much again, without a residual.
        if (report_.converged() && report_.iterations > 0 && !touch()) move_by_common();
    }

    // From where the common matrix has come, if it came nearer, else from the prediction.
    void iterate_with_exact() {
        const int before = report_.iterations;
        const bool came_nearer =
            report_.outcome == Outcome::out_of_iterations && largest_increment_ < increment_before_;
        report_ = EquilibriumReport{};
        if (!came_nearer) {
            begin(Prediction::from_start);
        } else if (contacts_.are_possible()) {
            for (std::size_t j = 0; j < stages_.count(); ++j)
                stages_.with_stage(j, [&] { limiter_.start_forces(state_, stages_.time_of(j)); });
        }
        if (are_blocked_) {
            report_.outcome = Outcome::out_of_iterations;
            return;
        }
        compute_residuals();
        bool is_current = false;
        while (!is_done()) {
            ++report_.iterations;
            if (!is_current && !factorize_exact()) break;
            if (!move_by_exact()) break;
            compute_residuals();
            is_current = report_.iterations > 1 && !is_slow(0.1) && !touch();
        }
        report_.iterations += before;
    }

    bool factorize_exact() {
        if (!own_.exact)
            own_.exact =
                std::make_unique<ExactMatrix>(system_, stages_.scheme, workspace_.linear_solver->kind());
        if (own_.exact->factorize(stages_, workspace_)) return true;
        report_.outcome = Outcome::singular;
        return false;
    }

    // Whether increments fall by less than this factor, though the residual is far from small.
    bool is_slow(double factor) const {
        constexpr int patience = 3;
        constexpr double near = 1e-6;
        if (report_.iterations < patience && factor > 0.1) return false;
        return largest_increment_ > factor * increment_before_ && report_.residual > near;
    }

    void update_rates() {
        stages_.scheme.update_stages(state_, stages_.step, system_.team());
        for (std::size_t j = 0; j < stages_.count(); ++j)
            system_.supports().set_rates(stages_.time_of(j), stages_.span(), state_.stage_motions[j]);
    }

    bool check_predicted() {
        if (are_blocked_) {
            report_.outcome = Outcome::out_of_iterations;
            return false;
        }
        for (std::size_t j = 0; j < stages_.count(); ++j) {
            const std::vector<NodeMotion>& motions = state_.stage_motions[j];
            const auto predicted = [&](std::size_t node) { return motions[node].theta; };
            if (!guards_[j].admits(state_.previous, predicted, report_) ||
                !check_step_rotations(system_, motions, report_))
                return false;
        }
        return true;
    }

    void compute_residuals() {
        const PhaseTimer timer(workspace_.seconds.assembly);
        report_.residual = 0.0;
        report_.joint_gap = {};
        for (std::size_t j = 0; j < stages_.count(); ++j) {
            EquilibriumReport& report = stage_reports_[j];
            report.iterations = report_.iterations;
            stages_.with_stage(j, [&] {
                system_.compute_residual(state_, stages_.time_of(j), own_.residuals[j], stages_.request());
                tests_[j].measure(own_.residuals[j], report);
                if (!system_.joints().empty())
                    report.joint_gap = system_.joints().measure_gap(own_.residuals[j].rows, state_);
            });
            if (report.joint_gap.size >= report_.joint_gap.size) report_.joint_gap = report.joint_gap;
            if (report.residual <= report_.residual || report_.outcome == Outcome::not_finite) continue;
            report_.outcome = report.outcome;
            report_.residual = report.residual;
            report_.worst_node = report.worst_node;
            report_.worst_component = report.worst_component;
        }
    }

    bool is_done() {
        if (report_.outcome == Outcome::not_finite) return true;
        const auto must_move = [](const ContactTrial& contact) { return contact.progress < 1.0; };
        bool all_met = std::ranges::none_of(own_.contacts, must_move);
        for (std::size_t j = 0; j < stages_.count(); ++j)
            all_met = all_met && tests_[j].is_met(own_.residuals[j], stage_reports_[j]);
        if (all_met) return true;
        if (report_.iterations < settings_.max_iterations) return false;
        report_.outcome = Outcome::out_of_iterations;
        return true;
    }

    bool move_by_common() {
        own_.common.solve(stages_, own_.residuals, workspace_, increments_);
        return apply(true);
    }

    bool move_by_exact() {
        for (std::size_t j = 0; contacts_.are_possible() && j < stages_.count(); ++j) {
            stages_.with_stage(j, [&] {
                limiter_.replace_by_tangent_forces(state_, stages_.time_of(j), 1.0, own_.residuals[j]);
            });
        }
        own_.exact->solve(stages_, own_.residuals, workspace_, increments_);
        return apply(false);
    }

    // Moves all stages; false, and so reported, if an increment is not finite or turns too far.
    bool apply(bool is_common) {
        const PhaseTimer timer(workspace_.seconds.update);
        increment_before_ = largest_increment_;
        largest_increment_ = 0.0;
        for (std::size_t j = 0; j < stages_.count(); ++j) {
            if (!increments_[j].allFinite()) {
                report_.outcome = Outcome::not_finite;
                report_.worst_node = report_.worst_component = -1;
                return false;
            }
            if (!apply_to(j, is_common)) return false;
        }
        update_rates();
        return true;
    }

    bool apply_to(std::size_t j, bool is_common) {
        std::vector<Vec6>& deltas = workspace_.increments;
        deltas.resize(state_.trial.size());
        for (std::size_t node = 0; node < deltas.size(); ++node)
            deltas[node] = system_.equations().increment_of(static_cast<int>(node), increments_[j]);
        if (is_common) CommonMatrix::turn_increments(stages_, j, deltas);
        bool is_admitted = true;
        stages_.with_stage(j, [&] {
            tests_[j].add_increment(deltas, state_);
            largest_increment_ = std::max(largest_increment_, tests_[j].last_increment());
            const ContactLimits limits = limiter_.limit_increment(deltas, state_, stages_.time_of(j));
            report_.least_gap = std::min(report_.least_gap, limits.least_gap);
            if (limits.shorten()) ++report_.shortened;
            const auto spin = [&](std::size_t node) -> Vec3 { return deltas[node].tail<3>(); };
            is_admitted = guards_[j].admits(state_.trial, spin, report_);
            if (!is_admitted) return;
            if (!system_.joints().empty()) {
                const std::vector<double>& values = is_common ? workspace_.values : own_.exact->values_of(j);
                system_.joints().advance_multipliers(deltas, increments_[j], values, state_);
            }
            system_.team().for_each_range(deltas.size(), [&](std::size_t first, std::size_t last) {
                for (std::size_t node = first; node < last; ++node)
                    apply_spin(state_.previous[node],
                               deltas[node].head<3>(),
                               deltas[node].tail<3>(),
                               state_.trial[node]);
            });
        });
        return is_admitted && check_step_rotations(system_, state_.stage_motions[j], report_);
    }

    void finish() {
        workspace_.stage_powers.clear();
        for (std::size_t j = 0; j < stages_.count(); ++j) {
            stages_.with_stage(j, [&] {
                workspace_.stage_powers.push_back(
                    compute_power(system_, state_, stages_.time_of(j), own_.residuals[j], stages_.span()));
            });
        }
        if (stages_.scheme.error_order() > 0)
            own_.common.estimate_errors(stages_, workspace_, own_.placement_errors, own_.rate_errors);
        stages_.scheme.end_step(state_, stages_.step, system_.team());
        if (!check_step_rotations(system_, state_.trial, report_)) return;
        state_.joints_trial = state_.stage_joints.back();
        workspace_.residual = own_.residuals.back();
        if (contacts_.are_possible()) state_.contact = own_.contacts.back();
    }

    const StagesOfStep& stages_;
    const System& system_;
    State& state_;
    const NewtonSettings& settings_;
    SolverWorkspace& workspace_;
    CoupledWorkspace& own_;
    Contacts contacts_;
    StepLimiter limiter_;
    bool are_blocked_ = false;  // whether moved supports would take what they hold into touch
    EquilibriumReport report_;
    std::vector<EquilibriumReport> stage_reports_;
    std::vector<ConvergenceTest> tests_;
    std::vector<RotationGuard> guards_;
    std::vector<Eigen::VectorXd> increments_;  // of each stage
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
    StagesOfStep stages{
        system, scheme, step, state, system.joints().are_linear(), workspace.coupled->contacts};
    EquilibriumReport report = CoupledNewton(stages, settings, workspace).solve();
    workspace.coupled->asks_for_positions = stages.asks_for_positions;
    if (report.converged() || stages.asks_for_positions) return report;
    // Where joints are redundant their accelerations can contradict each other; positions do not. Where bars
    // come into line the equations of joints change their rank within the step, and no common matrix serves.
    stages.asks_for_positions = workspace.coupled->asks_for_positions = true;
    const int before = report.iterations;
    report = CoupledNewton(stages, settings, workspace).solve();
    report.iterations += before;
    return report;
}

}  // namespace gxrod
