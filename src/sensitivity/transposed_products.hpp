#pragma once

#include <Eigen/Core>
#include <vector>

#include "assembly/system.hpp"
#include "solvers/equilibrium.hpp"

namespace gxrod {

// One number for each equation of joints, in the order of Residual::rows.
using RowNumbers = std::vector<double>;

// Take the numbers of the equations of joints out of a vector of all unknowns, or put them into it.
RowNumbers take_rows(const System& system, const Eigen::VectorXd& vector);
void put_rows(const System& system, const RowNumbers& rows, Eigen::VectorXd& vector);
// Returns the scales D of these equations in a tangent with these values.
RowNumbers list_scales(const System& system, const std::vector<double>& values);

// Solves with the transposed tangent in the workspace, which is factorized; `values` are those of the
// tangent. What the regularization of joints leaves is taken from the solution.
void solve_transposed(const System& system,
                      const std::vector<double>& values,
                      SolverWorkspace& workspace,
                      Eigen::VectorXd& vector);

// Derivatives of ξ · R − p · Φ by all motions of nodes, those that supports hold too; R are the residual
// forces on nodes, with those of joints, and Φ the equations of joints, at the level of a request.
class TransposedProducts {
  public:
    explicit TransposedProducts(const Model& model);

    // Computes them for the unknowns that the linearization has, the same for each node, at the trial
    // motions.
    std::vector<Vec6> compute(const State& state,
                              double time,
                              const ConstraintRequest& request,
                              const NodeLinearization& by,
                              const std::vector<Vec6>& xi,
                              const RowNumbers& p);
    // Return Gᵀp and Gξ of the last computation, G = ∂Φ/∂(δr, δφ) of positions.
    const std::vector<Vec6>& forces() const { return forces_; }
    const RowNumbers& gradient() const { return gradient_; }
    void forget_loads() const { system_.forget_loads(); }

  private:
    std::vector<Vec6> spread(const Eigen::VectorXd& vector) const;

    Model model_;  // without supports
    System system_;
    std::vector<double> unscaled_;  // with D = 1
    std::vector<double> values_;
    std::vector<Vec6> forces_;
    RowNumbers gradient_;
};

}  // namespace gxrod
