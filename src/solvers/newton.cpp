#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "assembly/contact/contact_limits.hpp"
#include "assembly/contact/contacts.hpp"
#include "assembly/contact/step_limiter.hpp"
#include "assembly/lanes/frame_columns.hpp"
#include "solvers/convergence_test.hpp"
#include "solvers/difference_tangent.hpp"
#include "solvers/newton_steps.hpp"
#include "solvers/paired_matrix.hpp"
#include "solvers/pseudo_step.hpp"
#include "solvers/rotation_guard.hpp"
#include "solvers/trial_moves.hpp"
#include "solvers/trial_rates.hpp"
#include "state/increment.hpp"

namespace gxrod {

namespace {

// How often an equilibrium is sought anew with more drag between rods.
constexpr int most_drags = 8;

// Whether an increment has at least halved a number, and so much that few more such ones take it to its goal.
bool falls_fast(double before, double now, double goal) {
    constexpr double half = 0.5;
    constexpr double few = 4.0;  // increments cost about as much as one with a tangent of its own
    return now <= half * before && std::log(goal / now) >= few * std::log(now / before);
}

// Newton's method on one stage; the members are what its steps share.
class Newton {
  public:
    Newton(const SolverSetup& setup,
           const Stage& stage,
           const ConstraintRequest& request,
           SolverWorkspace& workspace,
           State& state,
           const PseudoStep* pseudo_step = nullptr)
        : system_(setup.system),
          team_(system_.team()),
          integrator_(setup.integrator),
          settings_(setup.settings),
          stage_(stage),
          time_(integrator_.stage_time(stage)),
          request_(request),
          moves_supports_(integrator_.is_static() && system_.supports().move()),
          contacts_(system_),
          is_static_contact_(integrator_.is_static() && contacts_.are_possible() && !contacts_.couple_rods()),
          limiter_(system_),
          limits_rotation_(!integrator_.is_static() || system_.traits().uses_step_rotations),
          workspace_(workspace),
          state_(state),
          pseudo_step_(pseudo_step),
          may_overshoot_(!contacts_.are_possible() && !integrator_.is_static() &&
                         !system_.model().has_inertia && pseudo_step == nullptr &&
                         (system_.model().surroundings.water || system_.model().surroundings.air)),
          may_keep_(settings_.tangent == TangentKind::kept && !contacts_.are_possible() &&
                    !system_.joints().have_stops() && !may_overshoot_),
          convergence_(system_, settings_, request_.level),
          guard_(system_) {
        if (pseudo_step == nullptr) return;
        drag_ = pseudo_step->make_tangent();
        request_.added = &drag_;
    }

    EquilibriumReport solve() {
        const EquilibriumReport report = iterate();
        workspace_.is_paired = false;
        return report;
    }

  private:
    EquilibriumReport iterate() {
        predict();
        start_resultants();
        if (!admit_prediction() || !check_rotations()) return report_;
        compute_residual();
        while (!is_done()) {
            if (!keeps_tangent()) {
                compute_tangent();
                if (!factorize(system_, workspace_, report_)) break;
            }
            ++report_.iterations;
            if (!solve_increment(system_, compute_right_hand_side(), workspace_, report_)) break;
            if (!(may_overshoot_ ? apply_part() : apply(workspace_.vector))) break;
            if (!may_overshoot_) compute_residual();
        }
        return report_;
    }

    Eigen::VectorXd compute_right_hand_side() {
        const PhaseTimer timer(workspace_.seconds.assembly);
        limiter_.replace_by_tangent_forces(state_, time_, request_.contact_weight, workspace_.residual);
        Eigen::VectorXd residual = gather_residual(system_, workspace_.residual, workspace_.values);
        if (!moves_supports_) return residual;
        constexpr double part = 1e-6;
        return residual + compute_support_motion_force(
                              system_, time_, time_, part, workspace_.residual, workspace_.values, state_);
    }

    // Without inertia, drag ~ v² resists nothing at rest: from there the increment overshoots the velocity by
    // orders of magnitude, the more the shorter the step. It is shortened until what is out of balance is not
    // much larger than before. False, and so reported, if no part of it will do.
    bool apply_part() {
        constexpr double small = 1e-6;
        constexpr double much = 10.0;
        constexpr double least = 1e-8;
        if (report_.residual < small) {
            if (!apply(workspace_.vector)) return false;
            compute_residual();
            return true;
        }
        const double before = largest_component(system_, workspace_.residual);
        const EquilibriumReport report = report_;
        const ConvergenceTest convergence = convergence_;
        const std::vector<NodeMotion> trial = state_.trial;
        const std::vector<JointState> joints = state_.joints_trial;
        const auto resultants = state_.resultants;
        const bool moves_supports = moves_supports_;
        const Eigen::VectorXd increment = workspace_.vector;
        bool is_applied = false;
        for (double part = 1.0; part > least; part *= 0.25) {
            if (part < 1.0) {
                report_ = report;
                convergence_ = convergence;
                state_.trial = trial;
                state_.joints_trial = joints;
                state_.resultants = resultants;
                moves_supports_ = moves_supports;
                workspace_.vector = part * increment;
            }
            is_applied = apply(workspace_.vector);
            if (!is_applied) continue;
            compute_residual();
            if (largest_component(system_, workspace_.residual) <= much * before) return true;
        }
        return is_applied;
    }

    void predict() {
        const PhaseTimer timer(workspace_.seconds.update);
        if (pseudo_step_ != nullptr) {
            state_.trial_time = time_;
            return;
        }
        integrator_.begin_stage(state_, stage_, team_);
        if (integrator_.is_static()) {
            limit_prediction();
            return;
        }
        limiter_.begin_at_rest(state_);
        system_.supports().place(time_, state_);
        limit_prediction();
        update_trial_rates(system_, integrator_, stage_, state_);
        if (system_.joints().empty() || request_.level == ConstraintLevel::position) return;
        // Of accelerations, equations are as large as those of positions.
        integrator_.linearize(state_, stage_, workspace_.linearizations, team_);
        request_.factor = 1.0 / workspace_.linearizations.front().acceleration;
    }

    // False, and so reported, if it turns nodes too far.
    bool admit_prediction() {
        if (pseudo_step_ != nullptr)
            return guard_.admits(
                state_.trial, [](std::size_t) { return Vec3(Vec3::Zero()); }, report_);
        const auto predicted = [&](std::size_t node) { return state_.trial[node].theta; };
        return guard_.admits(state_.previous, predicted, report_);
    }

    // Takes the prediction as far as nothing touches.
    void limit_prediction() {
        if (limiter_.limit_prediction(state_, time_).shorten()) {
            ++report_.shortened;
            moves_supports_ = system_.supports().move();
        }
        if (!workspace_.paired) return;
        workspace_.paired->start(contacts_.list_groups(state_));
        workspace_.is_paired = true;
    }

    void start_resultants() {
        const PhaseTimer timer(workspace_.seconds.assembly);
        state_.resultants.clear();
        if (settings_.tangent != TangentKind::mixed) return;
        system_.start_resultants(state_);
        if (pseudo_step_ == nullptr) return;
        const std::vector<Vec6> none(state_.trial.size(), Vec6::Zero());
        system_.advance_resultants(none, state_);
    }

    void compute_residual() {
        const PhaseTimer timer(workspace_.seconds.assembly);
        system_.compute_residual(state_, time_, workspace_.residual, request_);
        for (std::size_t i = 0; i < workspace_.held_back.size(); ++i)
            workspace_.residual.nodal[i] -= workspace_.held_back[i];
        if (pseudo_step_ != nullptr) pseudo_step_->add_forces(state_, workspace_.residual);
        convergence_.measure(workspace_.residual, report_);
        if (!system_.joints().empty())
            report_.joint_gap = system_.joints().measure_gap(workspace_.residual.rows, state_);
    }

    // Whether to stop, be it converged, out of iterations or NaN.
    bool is_done() {
        if (report_.outcome == Outcome::not_finite) return true;
        const bool must_move = moves_supports_ || state_.contact.progress < 1.0;
        if (!must_move && convergence_.is_met(workspace_.residual, report_)) {
            if (drags_ == most_drags || !limiter_.counter_gain(state_)) return true;
            ++drags_;
            compute_residual();
        }
        if (report_.iterations < settings_.max_iterations && !goes_round()) return false;
        report_.outcome = Outcome::out_of_iterations;
        return true;
    }

    // Whether what touches in statics changes from iteration to iteration and comes back, again and again:
    // the worst node, its residual and the increment are those of a number of iterations before, all the way
    // back. Increments that were shortened make progress.
    bool goes_round() {
        constexpr std::size_t longest = 24;
        constexpr std::size_t least = 8;  // iterations that have to agree
        constexpr double same = 0.05;
        if (!is_static_contact_ || report_.iterations == 0) return false;
        course_.push_back({report_.worst_node, report_.residual, convergence_.last_increment()});
        const auto agree = [&](const Passed& a, const Passed& b) {
            return a.node == b.node && std::abs(a.residual - b.residual) <= same * b.residual &&
                   std::abs(a.increment - b.increment) <= same * b.increment;
        };
        for (std::size_t period = 2; period <= longest; ++period) {
            const std::size_t count = std::max(period, least);
            if (count + period > course_.size()) break;
            const auto last = course_.end() - static_cast<std::ptrdiff_t>(count);
            if (std::equal(last, course_.end(), last - static_cast<std::ptrdiff_t>(period), agree))
                return true;
        }
        return false;
    }

    // Whether the tangent of an earlier iteration is good enough: residual and gap of joints are at least
    // halved by each increment, and few more reach their goals.
    bool keeps_tangent() {
        const double residual = std::exchange(residual_before_, report_.residual);
        const double gap = std::exchange(gap_before_, report_.joint_gap.size);
        if (!may_keep_ || report_.iterations == 0) return false;
        constexpr double closed = 1e-12;
        const double tolerance = settings_.tolerance.value_or(usual_newton_tolerance);
        return falls_fast(residual, report_.residual, tolerance) &&
               (report_.joint_gap.size <= closed || falls_fast(gap, report_.joint_gap.size, closed));
    }

    void compute_tangent() {
        const PhaseTimer timer(workspace_.seconds.assembly);
        switch (settings_.tangent) {
            case TangentKind::mixed:  // the state holds resultants
            case TangentKind::automatic:
            case TangentKind::consistent:
            case TangentKind::kept:
                integrator_.linearize(state_, stage_, workspace_.linearizations, team_);
                system_.compute_tangent(
                    state_, time_, workspace_.linearizations, workspace_.values, request_);
                if (workspace_.frame) workspace_.frame->add_stiffness(state_, time_, workspace_.values);
                pair_tangent();
                break;
            case TangentKind::paper:
                assert(integrator_.has_paper_tangent());
                integrator_.linearize_as_paper(state_, stage_, workspace_.linearizations, team_);
                system_.compute_tangent(state_, time_, workspace_.linearizations, workspace_.values);
                break;
            case TangentKind::difference:
                compute_difference_tangent();
                pair_tangent();
                break;
        }
    }

    // Contact has its own derivatives, whose forces are unknowns apart within an iteration.
    void compute_difference_tangent() {
        integrator_.linearize(state_, stage_, workspace_.linearizations, team_);
        std::vector<double> added(static_cast<std::size_t>(system_.pattern().nonzeros()), 0.0);
        if (request_.added != nullptr) added = *request_.added;
        contacts_.add_tangents(state_, time_, request_, workspace_.linearizations, added);
        ConstraintRequest without_contact = request_;
        without_contact.contact_weight = 0.0;
        without_contact.added = &added;
        DifferenceTangent(system_).compute(integrator_, stage_, state_, workspace_.values, without_contact);
    }

    // Adds the tangents of rods that touch each other.
    void pair_tangent() {
        if (!workspace_.paired) return;
        workspace_.paired->set_values(
            workspace_.values,
            contacts_.compute_tangents(state_, request_.contact_weight, workspace_.linearizations));
    }

    // False, and so reported, if the increment turns too far.
    bool apply(const Eigen::VectorXd& increment) {
        const PhaseTimer timer(workspace_.seconds.update);
        std::vector<Vec6>& deltas = workspace_.increments;
        deltas.resize(state_.trial.size());
        team_.for_each_range(deltas.size(), [&](std::size_t first, std::size_t last) {
            for (std::size_t node = first; node < last; ++node)
                deltas[node] = system_.equations().increment_of(static_cast<int>(node), increment);
        });
        convergence_.add_increment(deltas, state_);
        bool places_supports = moves_supports_;
        if (places_supports) {
            std::vector<Vec6> with_supports = deltas;
            add_support_motion(system_, time_, state_, with_supports);
            const bool is_moderate = moderate(with_supports);
            if (!limit_increment(with_supports) || !is_moderate) {
                deltas = with_supports;
                places_supports = false;
            }
            if (!admit(with_supports)) return false;
        } else {
            moderate(deltas);
            limit_increment(deltas);
            if (!admit(deltas)) return false;
        }
        move_nodes(deltas);
        if (places_supports) {
            system_.supports().place(time_, state_);
            moves_supports_ = false;
        }
        update_trial_rates(system_, integrator_, stage_, state_);
        return check_rotations();
    }

    // Shortens an increment of statics after the first one that turns nodes by much, where contact has
    // stopped an earlier one: its tangent saw few of the forces that hold what it moves. False if so.
    bool moderate(std::vector<Vec6>& deltas) {
        constexpr double enough = 0.025;  // in rad
        if (!is_static_contact_) return true;
        double turn = 0.0;
        for (const Vec6& delta : deltas) turn = std::max(turn, delta.tail<3>().norm());
        if (report_.iterations == 1) first_turn_ = turn;
        const double most = std::max(enough, first_turn_);
        if (report_.shortened == 0 || !(turn > most)) return true;
        for (Vec6& delta : deltas) delta *= most / turn;
        course_.clear();
        return false;
    }

    // Shortens the increments of parts of the model in which a gap would close; false if any.
    bool limit_increment(std::vector<Vec6>& deltas) {
        const ContactLimits limits = limiter_.limit_increment(deltas, state_, time_);
        report_.least_gap = std::min(report_.least_gap, limits.least_gap);
        if (limits.shorten()) {
            ++report_.shortened;
            course_.clear();
        }
        return !limits.shorten();
    }

    // False, and so reported, if the increments turn nodes too far; else resultants go with them.
    bool admit(const std::vector<Vec6>& deltas) {
        const auto spin = [&](std::size_t node) -> Vec3 { return deltas[node].tail<3>(); };
        if (!guard_.admits(state_.trial, spin, report_)) return false;
        if (!system_.joints().empty())
            system_.joints().advance_multipliers(deltas, workspace_.vector, workspace_.values, state_);
        if (settings_.tangent == TangentKind::mixed) system_.advance_resultants(deltas, state_);
        return true;
    }

    void move_nodes(const std::vector<Vec6>& deltas) {
        team_.for_each_range(deltas.size(), [&](std::size_t first, std::size_t last) {
            for (std::size_t node = first; node < last; ++node) {
                const Vec3 delta_r = deltas[node].head<3>();
                const Vec3 delta_phi = deltas[node].tail<3>();
                NodeMotion& trial = state_.trial[node];
                if (settings_.tangent == TangentKind::paper) {
                    place(state_.previous[node], trial.r + delta_r, trial.theta + delta_phi, trial);
                } else {
                    apply_spin(state_.previous[node], delta_r, delta_phi, trial);
                }
            }
        });
    }

    bool check_rotations() {
        return !limits_rotation_ || check_step_rotations(system_, state_.trial, report_);
    }

    const System& system_;
    const ThreadTeam& team_;
    const Integrator& integrator_;
    const NewtonSettings& settings_;
    const Stage& stage_;
    double time_;
    ConstraintRequest request_;
    bool moves_supports_;  // until they are there; within the first iteration, unless contact stops them
    Contacts contacts_;
    bool is_static_contact_;  // with obstacles alone
    StepLimiter limiter_;
    bool limits_rotation_;
    SolverWorkspace& workspace_;
    State& state_;
    const PseudoStep* pseudo_step_;  // nullptr outside of pseudo-time
    std::vector<double> drag_;       // of the pseudo-step, on the system's pattern
    bool may_overshoot_;
    bool may_keep_;  // a tangent; what comes into touch within an equilibrium needs that of each iteration
    double residual_before_ = 0.0;
    double gap_before_ = 0.0;
    EquilibriumReport report_;
    ConvergenceTest convergence_;
    RotationGuard guard_;
    int drags_ = 0;
    double first_turn_ = 0.0;  // the largest one of the first increment
    struct Passed {
        int node;
        double residual, increment;
    };
    std::vector<Passed> course_;  // of statics with contact, since an increment was shortened
};

}  // namespace

EquilibriumReport solve_equilibrium(const SolverSetup& setup,
                                    const Stage& stage,
                                    SolverWorkspace& workspace,
                                    State& state,
                                    std::optional<ConstraintLevel> level) {
    ConstraintRequest request = find_request(setup.system, setup.integrator, stage);
    if (level) request.level = *level;
    const EquilibriumReport first = Newton(setup, stage, request, workspace, state).solve();
    const TangentKind tangent = setup.settings.tangent;
    const bool may_be_mixed = tangent == TangentKind::automatic;
    const bool may_be_consistent = tangent == TangentKind::mixed || tangent == TangentKind::kept;
    if (first.converged() || (!may_be_mixed && !may_be_consistent)) return first;
    // Past a limit point the consistent tangent's wilder increments may find a way; where a rod hardly
    // stretches, the mixed one does. The prediction does not depend on where the first attempt has left the
    // trial motions.
    NewtonSettings other = setup.settings;
    other.tangent = may_be_mixed ? TangentKind::mixed : TangentKind::consistent;
    EquilibriumReport report =
        Newton({setup.system, setup.integrator, other}, stage, request, workspace, state).solve();
    if (report.converged()) report.iterations += first.iterations;
    return report;
}

EquilibriumReport solve_pseudo_step(const SolverSetup& setup,
                                    const Stage& stage,
                                    const PseudoStep& step,
                                    SolverWorkspace& workspace,
                                    State& state) {
    assert(setup.integrator.is_static() && !Contacts(setup.system).are_possible());
    const ConstraintRequest request = find_request(setup.system, setup.integrator, stage);
    return Newton(setup, stage, request, workspace, state, &step).solve();
}

}  // namespace gxrod
