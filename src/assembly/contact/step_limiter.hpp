#pragma once

#include <vector>

#include "assembly/contact/contact_limits.hpp"
#include "assembly/residual.hpp"
#include "assembly/system.hpp"
#include "state/state.hpp"

namespace gxrod {

// Limits the motions of one equilibrium, so that no gap of contact closes before it has a force. Where
// nothing can touch it limits nothing.
class StepLimiter {
  public:
    // The system must outlive it.
    explicit StepLimiter(const System& system) : system_(&system), contact_(contact_assembly_of(system)) {}

    // Makes the prediction of a step with impulses the last accepted motions. Contact chatters between
    // impulses: if its accelerations go on, it touches where it should not, and half of the iterations are
    // spent on that. The first increment includes what moves.
    void begin_at_rest(State& state) const;
    // Shortens the predicted motions of the parts of the model in which a gap would close, and starts the
    // forces of contact there.
    ContactLimits limit_prediction(State& state, double time) const;
    // Shortens the increments of the parts of the model in which a gap would close, before nodes move.
    ContactLimits limit_increment(std::vector<Vec6>& deltas, State& state, double time) const;
    // Limit a motion that all parts of the model make together, as along a path, and shorten nothing: `least`
    // of the limits is the part of it in which no gap closes. After a prediction, nodes move and start_forces
    // is called; before an increment is made, the forces advance by the whole of it.
    ContactLimits limit_common_prediction(const std::vector<Vec6>& deltas, State& state, double time) const;
    void start_forces(State& state, double time) const;
    ContactLimits limit_common_increment(const std::vector<Vec6>& deltas, State& state, double time) const;
    // Replaces the forces of contact in the residual by the forces that belong to the tangents.
    void replace_by_tangent_forces(const State& state, double time, double weight, Residual& residual) const;
    // Raises the drag of touching rods if the impulses of a step that ends here add energy; returns whether
    // it was raised.
    bool counter_gain(State& state) const;

  private:
    // Returns the share of its motion that a node keeps.
    double share_of(std::size_t node, const ContactLimits& limits) const;

    const System* system_;
    const ContactAssembly* contact_;  // nullptr if nothing can touch
};

}  // namespace gxrod
