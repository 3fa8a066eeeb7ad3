#pragma once

#include <Eigen/Core>
#include <complex>
#include <memory>
#include <vector>

#include "linear/linear_solver.hpp"
#include "linear/stacked_pattern.hpp"

namespace gxrod {

// Solves complex systems (A + i B)(x + i y) = f + i g by real solvers, with twice the unknowns:
//   [A −B] [x]   [f]
//   [B  A] [y] = [g].
// The solver for chains does not exchange equations: it needs e^{−iψ} (A + i B) with a positive definite real
// part for some ψ; factors of the equations turn the matrix by ψ.
class ComplexAsReal {
  public:
    // Takes the same arguments as make_linear_solver. The pattern must outlive this.
    ComplexAsReal(LinearSolverKind kind,
                  const SparsePattern& pattern,
                  const ThreadTeam& team = ThreadTeam::alone());

    // Factorizes the matrix with these values times the factor of each equation.
    Factorization factorize(const std::vector<double>& real,
                            const std::vector<double>& imaginary,
                            const Eigen::VectorXcd& factors);
    // Replaces the right-hand side by the solution.
    void solve(Eigen::VectorXcd& right_hand_side);

  private:
    const SparsePattern* pattern_;
    StackedPattern stacked_;
    std::unique_ptr<LinearSolver> solver_;
    Eigen::VectorXcd factors_;
    std::vector<double> real_, imaginary_, values_;
    Eigen::VectorXd vector_, part_;
};

}  // namespace gxrod
