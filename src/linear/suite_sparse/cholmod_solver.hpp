#pragma once

#include <memory>

#include "linear/linear_solver.hpp"

namespace gxrod {

// CHOLMOD of SuiteSparse, with 64-bit indices: L D Lᵀ without pivoting of the symmetric part ½(A + Aᵀ), which
// is the matrix itself where the tangent is symmetric. D may have negative entries, at a small loss of digits
// that refinement makes good; a zero entry of D counts as singular even if an LU with pivoting would go on.
class CholmodSolver : public LinearSolver {
  public:
    explicit CholmodSolver(const SparsePattern& pattern);
    ~CholmodSolver() override;

    Factorization factorize(const std::vector<double>& values) override;
    void solve(Eigen::VectorXd& right_hand_side) override;
    LinearSolverKind kind() const override { return LinearSolverKind::cholmod; }

  private:
    struct Handles;
    std::unique_ptr<Handles> handles_;
    std::int64_t size_;
};

}  // namespace gxrod
