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

// Rates are turned by R = exp(θ), whose spin is δφ − R δφ_n.
void NewmarkIbrahimbegovic::transpose_rates(const State& state,
                                            double time_step,
                                            const MotionGradient& rates,
                                            MotionGradient& trial,
                                            MotionGradient& previous) const {
    for (std::size_t i = 0; i < rates.nodes.size(); ++i) {
        const MotionGradient::OfNode& rate = rates.nodes[i];
        transpose_translation(newmark_, time_step, rate, trial.nodes[i], previous.nodes[i]);
        const NodeMotion& motion = state.trial[i];
        const Quat back = exp_quaternion(motion.theta).conjugate();
        const Newmark::Transposed by = newmark_.transpose(back * rate.omega, back * rate.alpha, time_step);
        transpose_turn(motion.theta, by.increment, trial.nodes[i], previous.nodes[i]);
        const Vec3 turned = motion.omega.cross(rate.omega) + motion.alpha.cross(rate.alpha);
        trial.nodes[i].phi += turned;
        previous.nodes[i].phi -= back * turned;
        previous.nodes[i].omega += by.velocity_n;
        previous.nodes[i].alpha += by.acceleration_n;
    }
}

}  // namespace gxrod
