#include "integrators/newmark_ibrahimbegovic.hpp"

#include "rotation/rotation_map.hpp"
#include "rotation/tangent_map.hpp"

namespace gxrod {

void NewmarkIbrahimbegovic::place_nodes(State& state, const Stage& stage, NodeRange nodes) const {
    predict_constant_acceleration(state, stage.time_step, nodes);
    update_nodes(state, stage, nodes);
}

void NewmarkIbrahimbegovic::update_nodes(State& state, const Stage& stage, NodeRange nodes) const {
    const double dt = stage.time_step;
    for (std::size_t i = nodes.first; i < nodes.last; ++i) {
        const NodeMotion& previous = state.previous[i];
        NodeMotion& trial = state.trial[i];
        update_translation(newmark_, previous, dt, trial);
        const Vec3 unturned = newmark_.acceleration(trial.theta / dt, previous.omega, previous.alpha, dt);
        const Quat turn = exp_quaternion(trial.theta);
        trial.alpha = turn * unturned;
        trial.omega = turn * newmark_.velocity(previous.omega, previous.alpha, unturned, dt);
    }
}

void NewmarkIbrahimbegovic::linearize_nodes(const State& state,
                                            const Stage& stage,
                                            NodeRange nodes,
                                            std::vector<NodeLinearization>& linearizations) const {
    const double rate = newmark_.rate(stage.time_step);
    const double acceleration = newmark_.acceleration_rate(stage.time_step);
    for (std::size_t i = nodes.first; i < nodes.last; ++i) {
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
