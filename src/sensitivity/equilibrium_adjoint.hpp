#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "assembly/system.hpp"
#include "model/settings/settings.hpp"
#include "sensitivity/forward_sensitivity.hpp"

namespace gxrod {

// How one quantity of an equilibrium depends on numbers of the deck: with the multipliers λ of the
// equilibrium's equations, Kᵀ λ = (∂q/∂y)ᵀ, each number takes two more residuals but no solution
// (docs/theory/sensitivities.md, (G6), (G7)).
class EquilibriumAdjoint {
  public:
    // Of a system and trial motions of it; sides as of ForwardSensitivity::sides, −1 for the system itself.
    using Quantity = std::function<double(const System& system, const State& state, int side)>;

    // Of an accepted equilibrium under the loads at `time`, which must outlive this. The quantity depends on
    // the motion of these nodes alone. Throws std::invalid_argument if the state depends on how it was
    // reached, std::runtime_error if its tangent is singular.
    EquilibriumAdjoint(const System& system,
                       const State& state,
                       double time,
                       LinearSolverKind linear_solver,
                       const std::vector<int>& nodes,
                       const Quantity& quantity);

    // dq/dp. Throws std::invalid_argument if the models do not fit the system.
    double differentiate(const VariedModels& models, const Quantity& quantity) const;

  private:
    Eigen::VectorXd find_gradient(const std::vector<int>& nodes, const Quantity& quantity) const;

    const System& system_;
    State state_;
    double time_;
    LinearSolverKind linear_solver_;
    std::vector<double> values_;   // of the tangent
    Eigen::VectorXd multipliers_;  // λ
};

}  // namespace gxrod
