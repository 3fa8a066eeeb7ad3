#include "integrators/runge_kutta_4.hpp"

#include <algorithm>

#include "rotation/rotation_map.hpp"

namespace gxrod {

namespace {

// Rates of a motion: ṙ = v, q̇ = ½ ω q, v̇ = a, ω̇ = α. q is the quaternion before it was normalised: the
// equation for q is linear, and a scheme of order 4 only if it is integrated as it stands.
StageRates compute_rates(const NodeMotion& motion, const Quat& q) {
    const Quat omega(0.0, motion.omega.x(), motion.omega.y(), motion.omega.z());
    StageRates rates;
    rates.v = motion.v;
    rates.a = motion.a;
    rates.alpha = motion.alpha;
    rates.quaternion_dot = 0.5 * (omega * q).coeffs();
    return rates;
}

Quat compute_quaternion(const NodeMotion& previous, double h, const StageRates& rates) {
    return Quat(previous.Lambda.coeffs() + h * rates.quaternion_dot);
}

// previous + h × rates, accelerations aside.
void place_along(const NodeMotion& previous, double h, const StageRates& rates, NodeMotion& trial) {
    trial.r = previous.r + h * rates.v;
    trial.v = previous.v + h * rates.a;
    trial.omega = previous.omega + h * rates.alpha;
    trial.Lambda = compute_quaternion(previous, h, rates).normalized();
    trial.theta = log(trial.Lambda * previous.Lambda.conjugate());
    trial.a.setZero();
    trial.alpha.setZero();
}

// (k₁ + 2k₂ + 2k₃ + k₄)/6.
StageRates compute_mean(const State& state, std::size_t node) {
    constexpr double weights[RungeKutta4::stages] = {1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0};
    StageRates mean;
    for (int k = 0; k < RungeKutta4::stages; ++k) {
        const StageRates& rates = state.stages[k][node];
        mean.v += weights[k] * rates.v;
        mean.a += weights[k] * rates.a;
        mean.alpha += weights[k] * rates.alpha;
        mean.quaternion_dot += weights[k] * rates.quaternion_dot;
    }
    return mean;
}

}  // namespace

void RungeKutta4::place_nodes(State& state, const Stage& stage, NodeRange nodes) const {
    if (stage.index == 0) {
        for (std::size_t i = nodes.first; i < nodes.last; ++i) {
            state.stages[0][i] = compute_rates(state.previous[i], state.previous[i].Lambda);
        }
    }
    for (std::size_t i = nodes.first; i < nodes.last; ++i) {
        if (stage.index + 1 < stages) {
            const double h = stage_fraction(stage.index) * stage.time_step;
            place_along(state.previous[i], h, state.stages[stage.index][i], state.trial[i]);
        } else {
            place_along(state.previous[i], stage.time_step, compute_mean(state, i), state.trial[i]);
        }
    }
}

void RungeKutta4::linearize_nodes(const State&,
                                  const Stage&,
                                  NodeRange nodes,
                                  std::vector<NodeLinearization>& linearizations) const {
    for (std::size_t i = nodes.first; i < nodes.last; ++i) linearizations[i] = mass_linearization();
}

void RungeKutta4::finish_nodes(State& state, const Stage& stage, NodeRange nodes) const {
    if (stage.index + 1 == stages) return;
    const double h = stage_fraction(stage.index) * stage.time_step;
    for (std::size_t i = nodes.first; i < nodes.last; ++i) {
        const Quat q = compute_quaternion(state.previous[i], h, state.stages[stage.index][i]);
        state.stages[stage.index + 1][i] = compute_rates(state.trial[i], q);
    }
}

}  // namespace gxrod
