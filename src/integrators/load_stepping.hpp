#pragma once

#include "integrators/integrator.hpp"

namespace gxrod {

// Statics: a sequence of equilibria without rates, each sought from the last one. Time is the load factor.
class LoadStepping : public Integrator {
  public:
    void begin_stage(State& state, const Stage& stage) const override;
    void update_rates(State&, const Stage&) const override {}
    void linearize(const State& state,
                   const Stage& stage,
                   std::vector<NodeLinearization>& linearizations) const override;
    bool is_static() const override { return true; }
};

}  // namespace gxrod
