#pragma once

#include <memory>

#include "solvers/linear_solver.hpp"

namespace gxrod {

// KLU of SuiteSparse, with 64-bit indices.
class KluSolver : public LinearSolver {
  public:
    explicit KluSolver(const SparsePattern& pattern);
    ~KluSolver() override;

    Factorization factorize(const std::vector<double>& values) override;
    void solve(Eigen::VectorXd& right_hand_side) override;

  private:
    struct Handles;
    std::unique_ptr<Handles> handles_;
    const SparsePattern* pattern_;
};

}  // namespace gxrod
