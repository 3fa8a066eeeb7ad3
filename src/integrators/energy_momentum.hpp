#pragma once

#include "integrators/newmark_simplified.hpp"

namespace gxrod {

// Scheme (S) with β = ¼ and γ = ½, whose rates at the end of a step the solver corrects
// (solvers/conservation.hpp).
class EnergyMomentum : public NewmarkSimplified {
  public:
    EnergyMomentum() : NewmarkSimplified({0.25, 0.5}) {}

    bool has_paper_tangent() const override { return false; }
    bool conserves() const override { return true; }
};

}  // namespace gxrod
