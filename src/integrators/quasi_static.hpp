#pragma once

#include "integrators/sdirk_4.hpp"

namespace gxrod {

// Motion without inertia: at each stage of the scheme of Sdirk4, forces that may depend on rates are in
// equilibrium. θ_i = Δt Σ_j a_ij T(θ_j)⁻¹ ω_j, and accelerations are zero.
class QuasiStatic : public Sdirk4 {
  public:
    ConstraintLevel constraint_level(int) const override { return ConstraintLevel::position; }

  protected:
    void update_nodes(State& state, const Stage& stage, NodeRange nodes) const override;
    void linearize_nodes(const State& state,
                         const Stage& stage,
                         NodeRange nodes,
                         std::vector<NodeLinearization>& linearizations) const override;
};

}  // namespace gxrod
