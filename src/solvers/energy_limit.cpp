#include "solvers/energy_limit.hpp"

#include <cmath>
#include <map>
#include <optional>

#include "assembly/system_measures.hpp"
#include "linear/eigen/pencil.hpp"
#include "solvers/newton_steps.hpp"

namespace gxrod {

namespace {

using Vector = Eigen::VectorXd;

// The impulse of a damper with the time constant τ: (M + τ K) δ = −τ K v, with the stiffness K of the
// material alone, which no rigid motion strains.
class StiffnessDamper {
  public:
    StiffnessDamper(const System& system, const Stage& step, SolverWorkspace& workspace, State& state)
        : system_(system), workspace_(workspace), state_(state), before_(state.trial) {
        find_matrices(step);
        relative_ = gather(list_relative_rates(), system.equations(), system.team());
        pull_ = multiply(system.pattern(), stiffness_, relative_);
        energy_ = SystemMeasures(system).compute_kinetic_energy(state.trial);
    }

    double energy() const { return energy_; }
    // The rate at which a damper with a short τ takes energy, over τ.
    double strength() const { return relative_.dot(pull_); }

    // Sets the trial's velocities after the impulse. Returns the kinetic energy taken.
    std::optional<double> apply(double time_constant) {
        workspace_.values = mass_;
        for (std::size_t i = 0; i < mass_.size(); ++i) workspace_.values[i] += time_constant * stiffness_[i];
        EquilibriumReport report;
        if (!factorize(system_, workspace_, report)) return std::nullopt;
        if (!solve_increment(system_, time_constant * pull_, workspace_, report)) return std::nullopt;
        for (std::size_t node = 0; node < before_.size(); ++node) {
            const Vec6 change = system_.equations().increment_of(static_cast<int>(node), workspace_.vector);
            state_.trial[node].v = before_[node].v + change.head<3>();
            state_.trial[node].omega = before_[node].omega + change.tail<3>();
        }
        return energy_ - SystemMeasures(system_).compute_kinetic_energy(state_.trial);
    }

    void undo() {
        for (std::size_t node = 0; node < before_.size(); ++node) {
            state_.trial[node].v = before_[node].v;
            state_.trial[node].omega = before_[node].omega;
        }
    }

  private:
    void find_matrices(const Stage& step) {
        State still = state_;
        for (NodeMotion& motion : still.trial) {
            motion.v.setZero();
            motion.omega.setZero();
            motion.a.setZero();
            motion.alpha.setZero();
        }
        for (JointState& joint : still.joints_trial) joint.multipliers.fill(0.0);
        still.resultants.assign(still.sections.size(), Vec6::Zero());
        ConstraintRequest request{ConstraintLevel::position, {step.step_time, step.time_step}};
        request.contact_weight = 0.0;
        const std::size_t nodes = still.trial.size();
        system_.compute_tangent(still, step.end_time, mass_linearizations(nodes), mass_, request);
        const std::vector<NodeLinearization> placements(nodes, NodeLinearization{.placement = 1.0});
        system_.compute_tangent(still, step.end_time, placements, stiffness_, request);
    }

    // Velocities less those of a rigid motion with a support that moves the part.
    std::vector<Vec6> list_relative_rates() const {
        std::map<int, NodeMotion> movers;
        for (const Support* support : system_.supports().moving())
            movers.emplace(system_.scale_groups().part_of_node(support->node), before_[support->node]);
        std::vector<Vec6> rates(before_.size());
        for (std::size_t node = 0; node < rates.size(); ++node) {
            rates[node] << before_[node].v, before_[node].omega;
            const auto mover = movers.find(system_.scale_groups().part_of_node(static_cast<int>(node)));
            if (mover == movers.end()) continue;
            const NodeMotion& with = mover->second;
            rates[node].head<3>() -= with.v + with.omega.cross(before_[node].r - with.r);
            rates[node].tail<3>() -= with.omega;
        }
        return rates;
    }

    const System& system_;
    SolverWorkspace& workspace_;
    State& state_;
    std::vector<NodeMotion> before_;
    std::vector<double> mass_, stiffness_;
    Vector relative_, pull_;
    double energy_ = 0.0;
};

// Damps until the surplus is taken, and not much more. Returns what is taken: less, if vibrations have less.
double damp_vibrations(StiffnessDamper& damper, double surplus) {
    constexpr int most_trials = 12;
    constexpr double enough = 1.25;  // of the surplus
    const double strength = damper.strength();
    if (!(strength > 0.0)) return 0.0;
    double time_constant = surplus / strength;
    double too_short = 0.0, too_long = 0.0, taken = 0.0, best = 0.0;
    for (int trial = 0; trial < most_trials; ++trial) {
        const std::optional<double> now = damper.apply(time_constant);
        if (!now || !std::isfinite(*now)) break;
        const bool stagnates = trial > 0 && *now < 1.02 * taken && too_long == 0.0;
        taken = *now;
        if (taken >= surplus) {
            best = time_constant;
            if (taken <= enough * surplus) return taken;
            too_long = time_constant;
        } else {
            too_short = time_constant;
            if (stagnates) break;
        }
        const double factor = std::clamp(1.1 * surplus / std::max(taken, 0.01 * surplus), 0.01, 1e3);
        time_constant *= too_long == 0.0 ? std::max(factor * factor, 4.0) : factor;
        if (too_long > 0.0 && (time_constant >= too_long || time_constant <= too_short))
            time_constant = too_short > 0.0 ? std::sqrt(too_short * too_long) : 0.25 * too_long;
    }
    const double last = best > 0.0 ? best : too_short;
    if (last == 0.0) return 0.0;
    return damper.apply(last).value_or(0.0);
}

}  // namespace

double take_surplus(
    const System& system, const Stage& step, double surplus, SolverWorkspace& workspace, State& state) {
    constexpr double moderate = 0.1;  // of the kinetic energy, of what is taken from all that moves
    StiffnessDamper damper(system, step, workspace, state);
    double taken = damp_vibrations(damper, surplus);
    if (taken < 0.0) {
        damper.undo();
        taken = 0.0;
    }
    if (taken >= surplus) return taken;
    const double left = damper.energy() - taken;
    const double rest = surplus - taken;
    if (!(rest <= moderate * left)) {
        damper.undo();
        return 0.0;
    }
    const double factor = std::sqrt(1.0 - rest / left);
    for (NodeMotion& motion : state.trial) {
        motion.v *= factor;
        motion.omega *= factor;
    }
    system.supports().set_rates(step.end_time, {step.step_time, step.time_step}, state.trial);
    return damper.energy() - SystemMeasures(system).compute_kinetic_energy(state.trial);
}

}  // namespace gxrod
