#pragma once

#include "integrators/integrator.hpp"
#include "integrators/newmark.hpp"

namespace gxrod {

// Scheme (I), Ibrahimbegovic's Newmark scheme (Rubin 2007, (4.3)): the same update as (S) in the frame of the
// last step, then turned with the body by Λ(θ).
class NewmarkIbrahimbegovic : public Integrator {
  public:
    explicit NewmarkIbrahimbegovic(const Newmark& newmark) : newmark_(newmark) {}

  protected:
    void place_nodes(State& state, const Stage& stage, NodeRange nodes) const override;
    void update_nodes(State& state, const Stage& stage, NodeRange nodes) const override;
    void linearize_nodes(const State& state,
                         const Stage& stage,
                         NodeRange nodes,
                         std::vector<NodeLinearization>& linearizations) const override;

  private:
    Newmark newmark_;
};

}  // namespace gxrod
