#pragma once

#include "integrators/integrator.hpp"
#include "integrators/newmark.hpp"

namespace gxrod {

// Scheme (S), the simplified Newmark scheme for finite rotations (Rubin 2007, (4.7)): the vector update with
// w = θ/Δt (4.4) applied to spatial angular velocities. Second order for γ = ½.
class NewmarkSimplified : public Integrator {
  public:
    explicit NewmarkSimplified(const Newmark& newmark) : newmark_(newmark) {}

    void begin_stage(State& state, const Stage& stage) const override;
    void update_rates(State& state, const Stage& stage) const override;
    void linearize(const State& state,
                   const Stage& stage,
                   std::vector<NodeLinearization>& linearizations) const override;
    bool has_paper_tangent() const override { return true; }
    void linearize_as_paper(const State& state,
                            const Stage& stage,
                            std::vector<NodeLinearization>& linearizations) const override;

  private:
    Newmark newmark_;
};

}  // namespace gxrod
