#include "assembly/contact/step_limiter.hpp"

#include <utility>

#include "assembly/contact/contact_assembly.hpp"
#include "state/increment.hpp"

namespace gxrod {

double StepLimiter::share_of(std::size_t node, const ContactLimits& limits) const {
    const int part = system_->scale_groups().part_of_node(static_cast<int>(node));
    return limits.of_parts[static_cast<std::size_t>(part)];
}

void StepLimiter::begin_at_rest(State& state) const {
    if (!contact_ || !contact_->has_impacts()) return;
    for (std::size_t i = 0; i < state.trial.size(); ++i)
        place(state.previous[i], state.previous[i].r, Vec3::Zero(), state.trial[i]);
}

ContactLimits StepLimiter::limit_prediction(State& state, double time) const {
    if (!contact_) return {};
    const std::size_t count = state.trial.size();
    std::vector<NodeMotion> predicted = state.trial;
    std::vector<Vec6> increments(count);
    for (std::size_t i = 0; i < count; ++i)
        increments[i] << predicted[i].r - state.previous[i].r, predicted[i].theta;
    state.trial = state.previous;
    state.contact.progress = 0.0;
    state.contact.margin = 0.0;
    ContactLimits limits = contact_->limit(increments, state, time, Approach::prediction);
    state.trial = std::move(predicted);
    state.contact.progress = limits.least;
    for (std::size_t i = 0; limits.shorten() && i < count; ++i) {
        const double share = share_of(i, limits);
        if (share < 1.0)
            place(state.previous[i],
                  state.previous[i].r + share * increments[i].head<3>(),
                  share * state.trial[i].theta,
                  state.trial[i]);
    }
    contact_->start(state, time);
    return limits;
}

ContactLimits StepLimiter::limit_increment(std::vector<Vec6>& deltas, State& state, double time) const {
    if (!contact_) return {};
    ContactLimits limits = contact_->limit(deltas, state, time);
    contact_->advance(deltas, time, state);
    double& progress = state.contact.progress;
    progress = limits.shorten() ? progress + limits.least * (1.0 - progress) : 1.0;
    for (std::size_t i = 0; limits.shorten() && i < deltas.size(); ++i) deltas[i] *= share_of(i, limits);
    return limits;
}

ContactLimits StepLimiter::limit_common_prediction(const std::vector<Vec6>& deltas,
                                                   State& state,
                                                   double time) const {
    if (!contact_) return {};
    state.contact.progress = 1.0;
    state.contact.margin = 0.0;
    return contact_->limit(deltas, state, time, Approach::prediction);
}

void StepLimiter::start_forces(State& state, double time) const {
    if (contact_) contact_->start(state, time);
}

ContactLimits StepLimiter::limit_common_increment(const std::vector<Vec6>& deltas,
                                                  State& state,
                                                  double time) const {
    if (!contact_) return {};
    const ContactLimits limits = contact_->limit(deltas, state, time);
    contact_->advance(deltas, time, state);
    return limits;
}

void StepLimiter::replace_by_tangent_forces(const State& state,
                                            double time,
                                            double weight,
                                            Residual& residual) const {
    if (contact_) contact_->replace_by_tangent_forces(state, time, weight, residual);
}

bool StepLimiter::counter_gain(State& state) const {
    return contact_ && contact_->pairs().counter_gain(state);
}

}  // namespace gxrod
