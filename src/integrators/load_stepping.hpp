#pragma once

#include "integrators/integrator.hpp"

namespace gxrod {

// Statics: a sequence of equilibria without rates, each sought from the last one. Time is the load factor.
class LoadStepping : public Integrator {
  public:
    bool is_static() const override { return true; }
    bool has_transposed_rates() const override { return true; }

  protected:
    void place_nodes(State& state, const Stage& stage, NodeRange nodes) const override;
    void update_nodes(State&, const Stage&, NodeRange) const override {}
    void linearize_nodes(const State& state,
                         const Stage& stage,
                         NodeRange nodes,
                         std::vector<NodeLinearization>& linearizations) const override;
};

}  // namespace gxrod
