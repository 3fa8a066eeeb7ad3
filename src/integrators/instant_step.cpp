#include "integrators/instant_step.hpp"

#include "rotation/tangent_map.hpp"
#include "state/increment.hpp"

namespace gxrod {

void InstantStep::place_nodes(State& state, const Stage& stage, NodeRange nodes) const {
    for (std::size_t i = nodes.first; i < nodes.last; ++i)
        place(state.previous[i], state.previous[i].r, Vec3::Zero(), state.trial[i]);
    update_nodes(state, stage, nodes);
}

void InstantStep::update_nodes(State& state, const Stage& stage, NodeRange nodes) const {
    for (std::size_t i = nodes.first; i < nodes.last; ++i) {
        NodeMotion& trial = state.trial[i];
        trial.v = (trial.r - state.previous[i].r) / stage.time_step;
        trial.omega = tangent_map(trial.theta) * (trial.theta / stage.time_step);
        trial.a.setZero();
        trial.alpha.setZero();
    }
}

void InstantStep::linearize_nodes(const State& state,
                                  const Stage& stage,
                                  NodeRange nodes,
                                  std::vector<NodeLinearization>& linearizations) const {
    const double rate = 1.0 / stage.time_step;
    for (std::size_t i = nodes.first; i < nodes.last; ++i) {
        const Vec3& theta = state.trial[i].theta;
        const Mat3 d_omega = tangent_map_derivative(theta, rate * theta) * tangent_map_inverse(theta) +
                             rate * Mat3::Identity();
        linearizations[i] = {1.0, rate, 0.0, d_omega, Mat3::Zero()};
    }
}

}  // namespace gxrod
