#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "assembly/system.hpp"
#include "model/settings/settings.hpp"
#include "sensitivity/forward_sensitivity.hpp"

namespace gxrod {

// Derivatives of one quantity of an equilibrium by numbers of the deck. With the multipliers λ of the
// equilibrium's equations, Kᵀ λ = (∂q/∂y)ᵀ, each number costs two more residuals but no solution
// (docs/theory/sensitivities.md, (G6), (G7)).
class EquilibriumAdjoint {
  public:
    // A function of a system and its trial motions; `side` is an index of ForwardSensitivity::sides, −1 the
    // system itself.
    using Quantity = std::function<double(const System& system, const State& state, int side)>;

    // Takes an accepted equilibrium under the loads at `time`, which must outlive this. The quantity depends
    // on the motions of these nodes alone. Throws std::invalid_argument if the state depends on its history,
    // std::runtime_error if its tangent is singular.
    EquilibriumAdjoint(const System& system,
                       const State& state,
                       double time,
                       LinearSolverKind linear_solver,
                       const std::vector<int>& nodes,
                       const Quantity& quantity);

    // Computes dq/dp. Throws std::invalid_argument if the models do not fit the system.
    double differentiate(const VariedModels& models, const Quantity& quantity) const;

  private:
    Eigen::VectorXd find_gradient(const std::vector<int>& nodes, const Quantity& quantity) const;

    const System& system_;
    State state_;
    double time_;
    std::vector<double> values_;   // values of the tangent
    Eigen::VectorXd multipliers_;  // λ
};

}  // namespace gxrod
