#include "integrators/newmark_simplified.hpp"

#include <algorithm>

#include "rotation/tangent_map.hpp"

namespace gxrod {

void NewmarkSimplified::place_nodes(State& state, const Stage& stage, NodeRange nodes) const {
    predict_constant_acceleration(state, stage.time_step, nodes);
    update_nodes(state, stage, nodes);
}

void NewmarkSimplified::update_nodes(State& state, const Stage& stage, NodeRange nodes) const {
    const double dt = stage.time_step;
    for (std::size_t i = nodes.first; i < nodes.last; ++i) {
        const NodeMotion& previous = state.previous[i];
        NodeMotion& trial = state.trial[i];
        update_translation(newmark_, previous, dt, trial);
        trial.alpha = newmark_.acceleration(trial.theta / dt, previous.omega, previous.alpha, dt);
        trial.omega = newmark_.velocity(previous.omega, previous.alpha, trial.alpha, dt);
    }
}

void NewmarkSimplified::linearize_nodes(const State& state,
                                        const Stage& stage,
                                        NodeRange nodes,
                                        std::vector<NodeLinearization>& linearizations) const {
    const double rate = newmark_.rate(stage.time_step);
    const double acceleration = newmark_.acceleration_rate(stage.time_step);
    for (std::size_t i = nodes.first; i < nodes.last; ++i) {
        const Mat3 T_inverse = tangent_map_inverse(state.trial[i].theta);
        linearizations[i] = {1.0, rate, acceleration, rate * T_inverse, acceleration * T_inverse};
    }
}

void NewmarkSimplified::transpose_rates(const State& state,
                                        double time_step,
                                        const MotionGradient& rates,
                                        MotionGradient& trial,
                                        MotionGradient& previous) const {
    for (std::size_t i = 0; i < rates.nodes.size(); ++i) {
        transpose_translation(newmark_, time_step, rates.nodes[i], trial.nodes[i], previous.nodes[i]);
        const Newmark::Transposed by =
            newmark_.transpose(rates.nodes[i].omega, rates.nodes[i].alpha, time_step);
        transpose_turn(state.trial[i].theta, by.increment, trial.nodes[i], previous.nodes[i]);
        previous.nodes[i].omega += by.velocity_n;
        previous.nodes[i].alpha += by.acceleration_n;
    }
}

void NewmarkSimplified::linearize_nodes_as_paper(const State&,
                                                 const Stage& stage,
                                                 NodeRange nodes,
                                                 std::vector<NodeLinearization>& linearizations) const {
    const double rate = newmark_.rate(stage.time_step);
    const double acceleration = newmark_.acceleration_rate(stage.time_step);
    const NodeLinearization same{
        1.0, rate, acceleration, rate * Mat3::Identity(), acceleration * Mat3::Identity()};
    for (std::size_t i = nodes.first; i < nodes.last; ++i) linearizations[i] = same;
}

}  // namespace gxrod
