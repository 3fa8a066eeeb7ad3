#pragma once

#include <memory>

#include "linear/linear_solver.hpp"

namespace gxrod {

// KLU of SuiteSparse, with 64-bit indices: LU entry by entry, for systems with little fill.
class KluSolver : public LinearSolver {
  public:
    explicit KluSolver(const SparsePattern& pattern);
    ~KluSolver() override;

    Factorization factorize(const std::vector<double>& values) override;
    void solve(Eigen::VectorXd& right_hand_side) override;
    LinearSolverKind kind() const override { return LinearSolverKind::klu; }

    // Estimates additions and multiplications of a factorization over the entries of L, from the pattern
    // alone; 0 if not known. A large value means much fill.
    double estimate_flops_per_entry() const;

  private:
    struct Handles;
    std::unique_ptr<Handles> handles_;
    CompressedColumns columns_;
};

}  // namespace gxrod
