#pragma once

#include <Eigen/Core>
#include <complex>
#include <memory>
#include <vector>

#include "linear/linear_solver.hpp"

namespace gxrod {

// Complex systems (A + i B)(x + i y) = f + i g by solvers of real ones, with twice the unknowns:
//   [A −B] [x]   [f]
//   [B  A] [y] = [g],
// real and imaginary parts of a block of the pattern behind each other, so that blocks stay blocks. The
// solver for chains does not exchange equations: it needs e^{−iψ} (A + i B) with a positive definite real
// part for some ψ, by which factors of the equations it is turned.
class ComplexAsReal {
  public:
    // As make_linear_solver. The pattern must outlive it.
    ComplexAsReal(LinearSolverKind kind,
                  const SparsePattern& pattern,
                  const ThreadTeam& team = ThreadTeam::alone());

    // Of the matrix with these values times the factor of each equation.
    Factorization factorize(const std::vector<double>& real,
                            const std::vector<double>& imaginary,
                            const Eigen::VectorXcd& factors);
    // Replaces the right-hand side by the solution.
    void solve(Eigen::VectorXcd& right_hand_side);

  private:
    // The equations of a block: from `first`, of the doubled system from 2 × first.
    struct Rows {
        std::int64_t first, count;
    };
    static SparsePattern make_doubled(const SparsePattern& pattern, std::vector<Rows>& blocks);

    const SparsePattern* pattern_;
    std::vector<Rows> blocks_;
    SparsePattern doubled_;
    std::unique_ptr<LinearSolver> solver_;
    Eigen::VectorXcd factors_;
    std::vector<double> values_;
    Eigen::VectorXd vector_;
};

}  // namespace gxrod
