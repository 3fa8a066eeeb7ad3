#pragma once

#include "integrators/integrator.hpp"
#include "integrators/newmark.hpp"

namespace gxrod {

// Scheme (S), the simplified Newmark scheme for finite rotations (Rubin 2007, (4.7)): the vector update with
// w = θ/Δt (4.4) applied to spatial angular velocities. Second order for γ = ½.
class NewmarkSimplified : public Integrator {
  public:
    explicit NewmarkSimplified(const Newmark& newmark) : newmark_(newmark) {}

    bool has_paper_tangent() const override { return true; }

  protected:
    void place_nodes(State& state, const Stage& stage, NodeRange nodes) const override;
    void update_nodes(State& state, const Stage& stage, NodeRange nodes) const override;
    void linearize_nodes(const State& state,
                         const Stage& stage,
                         NodeRange nodes,
                         std::vector<NodeLinearization>& linearizations) const override;
    void linearize_nodes_as_paper(const State& state,
                                  const Stage& stage,
                                  NodeRange nodes,
                                  std::vector<NodeLinearization>& linearizations) const override;

  private:
    Newmark newmark_;
};

}  // namespace gxrod
