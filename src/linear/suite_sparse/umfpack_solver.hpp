#pragma once

#include <memory>

#include "linear/linear_solver.hpp"

namespace gxrod {

// UMFPACK of SuiteSparse, with 64-bit indices: LU by dense fronts, for systems with much fill.
class UmfpackSolver : public LinearSolver {
  public:
    explicit UmfpackSolver(const SparsePattern& pattern);
    ~UmfpackSolver() override;

    Factorization factorize(const std::vector<double>& values) override;
    void solve(Eigen::VectorXd& right_hand_side) override;
    LinearSolverKind kind() const override { return LinearSolverKind::umfpack; }

  private:
    struct Handles;
    std::unique_ptr<Handles> handles_;
    CompressedColumns columns_;
};

}  // namespace gxrod
