#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

#include "rotation/rotation_map.hpp"
#include "solvers/difference_tangent.hpp"
#include "solvers/newton_steps.hpp"
#include "solvers/trial_rates.hpp"
#include "state/increment.hpp"

namespace gxrod {

namespace {

constexpr double half_turn = std::numbers::pi;

// Newton's method on one stage; the members are what its steps share.
class Newton {
  public:
    Newton(const System& system,
           const Integrator& integrator,
           const NewtonSettings& settings,
           const Stage& stage,
           SolverWorkspace& workspace,
           State& state)
        : system_(system),
          team_(system.team()),
          integrator_(integrator),
          settings_(settings),
          tolerance_(settings.tolerance.value_or(usual_newton_tolerance)),
          stage_(stage),
          time_(integrator.stage_time(stage)),
          moves_supports_(integrator.is_static() && system.supports().move()),
          limits_rotation_(!integrator.is_static() || system.uses_step_rotations()),
          workspace_(workspace),
          state_(state) {}

    EquilibriumReport solve() {
        predict();
        start_resultants();
        const auto predicted = [&](std::size_t node) { return state_.trial[node].theta; };
        if (!check_rotations(state_.previous, predicted) || !check_step_rotations()) return report_;
        compute_residual();
        while (!is_done()) {
            compute_tangent();
            if (!factorize(system_, workspace_, report_)) break;
            ++report_.iterations;
            Eigen::VectorXd residual = gather(workspace_.residual.nodal, system_.equations(), team_);
            if (moves_supports_ && report_.iterations == 1) residual += compute_support_motion_force();
            if (!solve_increment(system_, residual, workspace_, report_)) break;
            if (!apply(workspace_.vector)) break;
            compute_residual();
        }
        return report_;
    }

  private:
    void predict() {
        const PhaseTimer timer(workspace_.seconds.update);
        integrator_.begin_stage(state_, stage_, team_);
        if (integrator_.is_static()) return;
        system_.supports().place(time_, state_);
        update_trial_rates(system_, integrator_, stage_, state_);
    }

    void start_resultants() {
        const PhaseTimer timer(workspace_.seconds.assembly);
        state_.resultants.clear();
        if (settings_.tangent == TangentKind::mixed) system_.start_resultants(state_);
    }

    void compute_residual() {
        const PhaseTimer timer(workspace_.seconds.assembly);
        residual_before_ = report_.iterations > 0 ? report_.residual : residual_before_;
        system_.compute_residual(state_, time_, workspace_.residual);
        measure_residual(system_, workspace_.residual, report_);
    }

    // Whether to stop, be it converged, out of iterations or NaN.
    bool is_done() {
        if (report_.outcome == Outcome::not_finite) return true;
        const bool small =
            settings_.absolute_residual > 0.0
                ? largest_component(system_, workspace_.residual) <= settings_.absolute_residual
                : report_.residual <= tolerance_;
        const bool supports_wait = moves_supports_ && report_.iterations == 0;
        if (!supports_wait && (small || has_reached_round_off())) return true;
        if (report_.iterations < settings_.max_iterations) return false;
        report_.outcome = Outcome::out_of_iterations;
        return true;
    }

    // Whether round-off is all that is left of the increments: far below the tolerance, a few units of the
    // last place, or small and no longer shrinking; or the next one would be, going by the last two, and the
    // residual no longer falls. Where round-off is as large as the forces, the tangent has lost digits too,
    // and two increments do not predict a third.
    bool has_reached_round_off() const {
        constexpr double rounding = 4.0 * std::numeric_limits<double>::epsilon();
        const double nothing = std::max(1e-4 * tolerance_, rounding);
        if (last_increment_ <= nothing) return true;
        if (last_increment_ <= 1e-10 && last_increment_ >= 0.5 * increment_before_) return true;
        if (report_.iterations < 2) return false;
        if (is_as_large_as_forces(system_, workspace_.residual, report_)) return false;
        const double next_increment = last_increment_ * (last_increment_ / increment_before_);
        return next_increment <= nothing && report_.residual >= 0.5 * residual_before_;
    }

    void compute_tangent() {
        const PhaseTimer timer(workspace_.seconds.assembly);
        switch (settings_.tangent) {
            case TangentKind::mixed:  // the state holds resultants
            case TangentKind::automatic:
            case TangentKind::consistent:
                integrator_.linearize(state_, stage_, workspace_.linearizations, team_);
                system_.compute_tangent(state_, time_, workspace_.linearizations, workspace_.values);
                break;
            case TangentKind::paper:
                assert(integrator_.has_paper_tangent());
                integrator_.linearize_as_paper(state_, stage_, workspace_.linearizations, team_);
                system_.compute_tangent(state_, time_, workspace_.linearizations, workspace_.values);
                break;
            case TangentKind::difference:
                DifferenceTangent(system_).compute(integrator_, stage_, state_, workspace_.values);
                break;
        }
    }

    // What moving the supports by their share of the step does to the residual, to first order: by a
    // difference, which is as good as any for a first guess.
    Eigen::VectorXd compute_support_motion_force() {
        const PhaseTimer timer(workspace_.seconds.assembly);
        constexpr double part = 1e-6;
        State moved = state_;
        system_.supports().place(time_, moved);
        State nudged = state_;
        for (const Support* support : system_.supports().moving()) {
            const NodeMotion& from = state_.trial[support->node];
            const NodeMotion& to = moved.trial[support->node];
            apply_spin(
                from, part * (to.r - from.r), part * (to.theta - from.theta), nudged.trial[support->node]);
        }
        Residual residual;
        system_.compute_residual(nudged, time_, residual);
        return (gather(residual.nodal, system_.equations()) -
                gather(workspace_.residual.nodal, system_.equations())) /
               part;
    }

    // The largest |δr| relative to its scale, or |δφ|.
    double measure(const std::vector<Vec6>& deltas) const {
        return team_.find_largest(deltas.size(), [&](std::size_t node) {
            const Vec6& delta = deltas[node];
            const double scale =
                std::max(system_.length_scale_at(static_cast<int>(node)), state_.trial[node].r.norm());
            return std::max(delta.head<3>().lpNorm<Eigen::Infinity>() / scale,
                            delta.tail<3>().lpNorm<Eigen::Infinity>());
        });
    }

    // False, and so reported, if the increment turns too far.
    bool apply(const Eigen::VectorXd& increment) {
        const PhaseTimer timer(workspace_.seconds.update);
        increment_before_ = last_increment_;
        std::vector<Vec6>& deltas = workspace_.increments;
        deltas.resize(state_.trial.size());
        team_.for_each_range(deltas.size(), [&](std::size_t first, std::size_t last) {
            for (std::size_t node = first; node < last; ++node)
                deltas[node] = system_.equations().increment_of(static_cast<int>(node), increment);
        });
        last_increment_ = measure(deltas);
        const bool places_supports = moves_supports_ && report_.iterations == 1;
        if (places_supports) {
            std::vector<Vec6> with_supports = deltas;
            add_support_motion(with_supports);
            if (!admit(with_supports)) return false;
        } else if (!admit(deltas)) {
            return false;
        }
        move_nodes(deltas);
        if (places_supports) system_.supports().place(time_, state_);
        update_trial_rates(system_, integrator_, stage_, state_);
        return check_step_rotations();
    }

    // False, and so reported, if the increments turn nodes too far; else resultants go with them.
    bool admit(const std::vector<Vec6>& deltas) {
        const auto spin = [&](std::size_t node) -> Vec3 { return deltas[node].tail<3>(); };
        if (!check_rotations(state_.trial, spin)) return false;
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

    // By how much moving supports will shift and turn their nodes, from the last equilibrium.
    void add_support_motion(std::vector<Vec6>& deltas) {
        std::vector<NodeMotion> before;
        for (const Support* support : system_.supports().moving()) {
            before.push_back(state_.trial[support->node]);
        }
        system_.supports().place(time_, state_);
        auto kept = before.begin();
        for (const Support* support : system_.supports().moving()) {
            NodeMotion& trial = state_.trial[support->node];
            deltas[support->node].head<3>() += trial.r - kept->r;
            deltas[support->node].tail<3>() += trial.theta - kept->theta;
            trial = *kept++;
        }
    }

    // False, and so reported, if these spins could turn nodes of one element against each other by half a
    // turn, beyond which no logarithm sees which way round they went.
    template <class SpinOf>
    bool check_rotations(const std::vector<NodeMotion>& motions, const SpinOf& spin) {
        relative_rotation_bound_ +=
            2.0 * team_.find_largest(motions.size(), [&](std::size_t node) { return spin(node).norm(); });
        if (relative_rotation_bound_ < half_turn) return true;
        std::vector<Vec3> spins(motions.size());
        for (std::size_t node = 0; node < spins.size(); ++node) spins[node] = spin(node);
        const RelativeRotation bound = system_.bound_relative_rotation(motions, spins);
        relative_rotation_bound_ = bound.angle;
        if (bound.angle < half_turn) return true;
        report_.outcome = Outcome::element_too_turned;
        report_.worst_node = bound.node;
        report_.worst_component = -1;
        return false;
    }

    // False, and so reported, if a node turned by π or more since the last accepted step.
    bool check_step_rotations() {
        const auto angle = [&](std::size_t node) { return state_.trial[node].theta.norm(); };
        if (!limits_rotation_ || team_.find_largest(state_.trial.size(), angle) < half_turn) return true;
        std::size_t node = 0;
        while (angle(node) < half_turn) ++node;
        report_.outcome = Outcome::rotation_too_large;
        report_.worst_node = static_cast<int>(node);
        report_.worst_component = -1;
        return false;
    }

    const System& system_;
    const ThreadTeam& team_;
    const Integrator& integrator_;
    const NewtonSettings& settings_;
    double tolerance_;
    const Stage& stage_;
    double time_;
    bool moves_supports_;  // within the first iteration
    bool limits_rotation_;
    SolverWorkspace& workspace_;
    State& state_;
    EquilibriumReport report_;
    // The largest |δr| relative to its scale, or |δφ|, of the last two iterations.
    double last_increment_ = std::numeric_limits<double>::infinity();
    double increment_before_ = std::numeric_limits<double>::infinity();
    double residual_before_ = std::numeric_limits<double>::infinity();  // the last iteration's
    // No relative rotation of an element's nodes is larger; at first that is not known.
    double relative_rotation_bound_ = half_turn;
};

}  // namespace

EquilibriumReport solve_equilibrium(const System& system,
                                    const Integrator& integrator,
                                    const NewtonSettings& settings,
                                    const Stage& stage,
                                    SolverWorkspace& workspace,
                                    State& state) {
    if (settings.tangent != TangentKind::mixed) {
        return Newton(system, integrator, settings, stage, workspace, state).solve();
    }
    const EquilibriumReport mixed = Newton(system, integrator, settings, stage, workspace, state).solve();
    if (mixed.converged()) return mixed;
    // Past a limit point the consistent tangent's wilder increments may find a way. The prediction does not
    // depend on where the first attempt has left the trial motions.
    NewtonSettings other = settings;
    other.tangent = TangentKind::consistent;
    EquilibriumReport report = Newton(system, integrator, other, stage, workspace, state).solve();
    if (report.converged()) report.iterations += mixed.iterations;
    return report;
}

}  // namespace gxrod
