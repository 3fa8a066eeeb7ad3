#include "integrators/newmark_simplified.hpp"

#include "rotation/tangent_map.hpp"

namespace gxrod {

void NewmarkSimplified::begin_stage(State& state, const Stage& stage) const {
    predict_constant_acceleration(state, stage.time_step);
    update_rates(state, stage);
}

void NewmarkSimplified::update_rates(State& state, const Stage& stage) const {
    const double dt = stage.time_step;
    for (std::size_t i = 0; i < state.trial.size(); ++i) {
        const NodeMotion& previous = state.previous[i];
        NodeMotion& trial = state.trial[i];
        update_translation(newmark_, previous, dt, trial);
        trial.alpha = newmark_.acceleration(trial.theta / dt, previous.omega, previous.alpha, dt);
        trial.omega = newmark_.velocity(previous.omega, previous.alpha, trial.alpha, dt);
    }
}

void NewmarkSimplified::linearize(const State& state,
                                  const Stage& stage,
                                  std::vector<NodeLinearization>& linearizations) const {
    const double rate = newmark_.rate(stage.time_step);
    const double acceleration = newmark_.acceleration_rate(stage.time_step);
    for (std::size_t i = 0; i < state.trial.size(); ++i) {
        const Mat3 T_inverse = tangent_map_inverse(state.trial[i].theta);
        linearizations[i] = {1.0, rate, acceleration, rate * T_inverse, acceleration * T_inverse};
    }
}

void NewmarkSimplified::linearize_as_paper(const State& state,
                                           const Stage& stage,
                                           std::vector<NodeLinearization>& linearizations) const {
    const double rate = newmark_.rate(stage.time_step);
    const double acceleration = newmark_.acceleration_rate(stage.time_step);
    const NodeLinearization same{
        1.0, rate, acceleration, rate * Mat3::Identity(), acceleration * Mat3::Identity()};
    linearizations.assign(state.trial.size(), same);
}

}  // namespace gxrod
