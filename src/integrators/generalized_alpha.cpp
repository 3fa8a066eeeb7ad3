#include "integrators/generalized_alpha.hpp"

#include <cmath>

#include "rotation/tangent_map.hpp"
#include "state/increment.hpp"

namespace gxrod {

GeneralizedAlpha::GeneralizedAlpha(double spectral_radius)
    : alpha_m_((2.0 * spectral_radius - 1.0) / (spectral_radius + 1.0)),
      alpha_f_(spectral_radius / (spectral_radius + 1.0)),
      newmark_{0.25 * (1.0 - alpha_m_ + alpha_f_) * (1.0 - alpha_m_ + alpha_f_), 0.5 - alpha_m_ + alpha_f_},
      lag_(newmark_.beta / newmark_.gamma - 0.5) {}

void GeneralizedAlpha::start(State& state) const {
    state.carried_trial.assign(2 * state.trial.size(), CarriedAcceleration{});
    for (std::size_t i = 0; i < state.trial.size(); ++i)
        algorithmic(state.carried_trial, i) = {state.trial[i].a, state.trial[i].alpha};
    state.carried_previous = state.carried_trial;
}

void GeneralizedAlpha::place_nodes(State& state, const Stage& stage, NodeRange nodes) const {
    const double dt = stage.time_step;
    for (std::size_t i = nodes.first; i < nodes.last; ++i) {
        const NodeMotion& previous = state.previous[i];
        const CarriedAcceleration& A = algorithmic(state.carried_previous, i);
        place(previous,
              previous.r + dt * previous.v + (0.5 * dt * dt) * A.a,
              dt * previous.omega + (0.5 * dt * dt) * A.alpha,
              state.trial[i]);
    }
    update_nodes(state, stage, nodes);
}

void GeneralizedAlpha::update_nodes(State& state, const Stage& stage, NodeRange nodes) const {
    const double dt = stage.time_step;
    // α from A, A_n and α_n.
    const auto accelerate = [this](const Vec3& A, const Vec3& A_n, const Vec3& alpha_n) -> Vec3 {
        return ((1.0 - alpha_m_) * A + alpha_m_ * A_n - alpha_f_ * alpha_n) / (1.0 - alpha_f_);
    };
    for (std::size_t i = nodes.first; i < nodes.last; ++i) {
        const NodeMotion& previous = state.previous[i];
        const CarriedAcceleration& A_n = algorithmic(state.carried_previous, i);
        const CarriedAcceleration& impulse = impulsive(state.carried_previous, i);
        CarriedAcceleration& A = algorithmic(state.carried_trial, i);
        NodeMotion& trial = state.trial[i];
        const Vec3 way = trial.r - previous.r + (lag_ * dt * dt) * impulse.a;
        const Vec3 turn = trial.theta + (lag_ * dt * dt) * impulse.alpha;
        A.a = newmark_.acceleration(way / dt, previous.v, A_n.a, dt);
        A.alpha = newmark_.acceleration(turn / dt, previous.omega, A_n.alpha, dt);
        impulsive(state.carried_trial, i) = {};
        trial.v = newmark_.velocity(previous.v, A_n.a, A.a, dt);
        trial.omega = newmark_.velocity(previous.omega, A_n.alpha, A.alpha, dt);
        trial.a = accelerate(A.a, A_n.a, previous.a);
        trial.alpha = accelerate(A.alpha, A_n.alpha, previous.alpha);
    }
}

double GeneralizedAlpha::contact_weight() const {
    return (1.0 - alpha_m_) / ((1.0 - alpha_f_) * newmark_.gamma);
}

void GeneralizedAlpha::split_impulses(State& state, const Stage& stage, std::vector<Vec6>& shocked) const {
    const double dt = stage.time_step;
    const double weight = contact_weight();
    // A from α, A_n and α_n.
    const auto lag = [this](const Vec3& alpha, const Vec3& A_n, const Vec3& alpha_n) -> Vec3 {
        return ((1.0 - alpha_f_) * alpha + alpha_f_ * alpha_n - alpha_m_ * A_n) / (1.0 - alpha_m_);
    };
    for (std::size_t i = 0; i < shocked.size(); ++i) {
        const NodeMotion& previous = state.previous[i];
        const NodeMotion& trial = state.trial[i];
        const CarriedAcceleration& A_n = algorithmic(state.carried_previous, i);
        CarriedAcceleration& A = algorithmic(state.carried_trial, i);
        A.a = lag(trial.a, A_n.a, previous.a);
        A.alpha = lag(trial.alpha, A_n.alpha, previous.alpha);
        impulsive(state.carried_trial, i) = {(trial.v - previous.v) / dt - A.a,
                                             (trial.omega - previous.omega) / dt - A.alpha};
        Vec6 smooth;
        smooth << trial.a, trial.alpha;
        shocked[i] = smooth + (shocked[i] - smooth) / weight;
    }
}

void GeneralizedAlpha::linearize_nodes(const State& state,
                                       const Stage& stage,
                                       NodeRange nodes,
                                       std::vector<NodeLinearization>& linearizations) const {
    const double rate = newmark_.rate(stage.time_step);
    const double acceleration =
        newmark_.acceleration_rate(stage.time_step) * (1.0 - alpha_m_) / (1.0 - alpha_f_);
    for (std::size_t i = nodes.first; i < nodes.last; ++i) {
        const Mat3 T_inverse = tangent_map_inverse(state.trial[i].theta);
        linearizations[i] = {1.0, rate, acceleration, rate * T_inverse, acceleration * T_inverse};
    }
}

void GeneralizedAlpha::transpose_rates(const State& state,
                                       double time_step,
                                       const MotionGradient& rates,
                                       MotionGradient& trial,
                                       MotionGradient& previous) const {
    const double part = 1.0 / (1.0 - alpha_f_);
    for (std::size_t i = 0; i < rates.nodes.size(); ++i) {
        const MotionGradient::OfNode& rate = rates.nodes[i];
        MotionGradient::OfNode& before = previous.nodes[i];
        const CarriedAcceleration& A = algorithmic(rates.carried, i);
        CarriedAcceleration& A_n = algorithmic(previous.carried, i);
        CarriedAcceleration& impulse = impulsive(previous.carried, i);
        const Newmark::Transposed way =
            newmark_.transpose(rate.v, A.a + part * (1.0 - alpha_m_) * rate.a, time_step);
        const Newmark::Transposed turn =
            newmark_.transpose(rate.omega, A.alpha + part * (1.0 - alpha_m_) * rate.alpha, time_step);
        trial.nodes[i].r += way.increment;
        before.r -= way.increment;
        transpose_turn(state.trial[i].theta, turn.increment, trial.nodes[i], before);
        impulse.a += lag_ * time_step * time_step * way.increment;
        impulse.alpha += lag_ * time_step * time_step * turn.increment;
        before.v += way.velocity_n;
        before.omega += turn.velocity_n;
        A_n.a += way.acceleration_n + part * alpha_m_ * rate.a;
        A_n.alpha += turn.acceleration_n + part * alpha_m_ * rate.alpha;
        before.a -= part * alpha_f_ * rate.a;
        before.alpha -= part * alpha_f_ * rate.alpha;
    }
}

// √(α_f − α_m) Δt times the mean over the step of how far accelerations are ahead of the algorithmic ones
// (docs/theory/energy.md, (E8)).
void GeneralizedAlpha::set_dissipated_rates(const State& state,
                                            double time_step,
                                            int,
                                            std::vector<NodeMotion>& rates) const {
    const double factor = 0.5 * std::sqrt(alpha_f_ - alpha_m_) * time_step;
    for (std::size_t i = 0; i < rates.size(); ++i) {
        const NodeMotion& previous = state.previous[i];
        const NodeMotion& trial = state.trial[i];
        const CarriedAcceleration& A_n = algorithmic(state.carried_previous, i);
        const CarriedAcceleration& A = algorithmic(state.carried_trial, i);
        rates[i].v = factor * (previous.a - A_n.a + trial.a - A.a);
        rates[i].omega = factor * (previous.alpha - A_n.alpha + trial.alpha - A.alpha);
    }
}

}  // namespace gxrod
