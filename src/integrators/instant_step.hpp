#pragma once

#include "integrators/integrator.hpp"

namespace gxrod {

// An equilibrium without inertia at the instant of a sudden load. Damped parts creep for a time h, the
// stage's time step, much shorter than the steps that follow: v = (r − rₙ)/h, ω = T(θ) θ/h
// (docs/theory/newmark.md, (Q1)).
class InstantStep : public Integrator {
  public:
    double contact_weight() const override { return 1.0; }

  protected:
    void place_nodes(State& state, const Stage& stage, NodeRange nodes) const override;
    void update_nodes(State& state, const Stage& stage, NodeRange nodes) const override;
    void linearize_nodes(const State& state,
                         const Stage& stage,
                         NodeRange nodes,
                         std::vector<NodeLinearization>& linearizations) const override;
};

}  // namespace gxrod
