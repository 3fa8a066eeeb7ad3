#include "integrators/newmark_ibrahimbegovic.hpp"

#include "rotation/rotation_map.hpp"
#include "rotation/tangent_map.hpp"

namespace gxrod {

void NewmarkIbrahimbegovic::begin_stage(State& state, const Stage& stage) const {
    predict_constant_acceleration(state, stage.time_step);
    update_rates(state, stage);
}

void NewmarkIbrahimbegovic::update_rates(State& state, const Stage& stage) const {
    const double dt = stage.time_step;
    for (std::size_t i = 0; i < state.trial.size(); ++i) {
        const NodeMotion& previous = state.previous[i];
        NodeMotion& trial = state.trial[i];
        update_translation(newmark_, previous, dt, trial);
        const Vec3 unturned = newmark_.acceleration(trial.theta / dt, previous.omega, previous.alpha, dt);
        const Quat turn = exp_quaternion(trial.theta);
        trial.alpha = turn * unturned;
        trial.omega = turn * newmark_.velocity(previous.omega, previous.alpha, unturned, dt);
    }
}

void NewmarkIbrahimbegovic::linearize(const State& state,
                                      const Stage& stage,
                                      std::vector<NodeLinearization>& linearizations) const {
    const double rate = newmark_.rate(stage.time_step);
    const double acceleration = newmark_.acceleration_rate(stage.time_step);
    for (std::size_t i = 0; i < state.trial.size(); ++i) {
        const NodeMotion& trial = state.trial[i];
        const Mat3 turned = tangent_map_inverse(trial.theta).transpose();  // Λ(θ) T(θ)⁻¹
        linearizations[i] = {1.0,
                             rate,
                             acceleration,
                             rate * turned - spin(trial.omega),
                             acceleration * turned - spin(trial.alpha)};
    }
}

}  // namespace gxrod
