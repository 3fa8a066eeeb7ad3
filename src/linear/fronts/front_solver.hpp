#pragma once

#include <Eigen/Core>

#include "linear/fronts/front_layout.hpp"

namespace gxrod {

// LU by dense fronts over blocks of unknowns, such as those of a node, for systems whose blocks fill in:
// systems of junctions. It does not pivot within blocks, so the caller must check the residual. The pattern
// must be symmetric and have its diagonal.
class FrontSolver {
  public:
    explicit FrontSolver(const SparsePattern& pattern);

    // Factorizes; returns false if a pivot vanishes.
    bool factorize(const std::vector<double>& values);
    // Estimates the operations of a factorization.
    double estimate_flops() const;
    // The number of negative pivots of the last regular factorization.
    std::int64_t negative_pivots() const { return negative_pivots_; }
    // Replaces the right-hand side by the solution, after a regular factorization.
    void solve(Eigen::VectorXd& right_hand_side);

  private:
    Fronts fronts() const;

    FrontLayout layout_;
    FrontKernels kernels_;
    std::vector<double> factors_;
    std::array<std::vector<double>, 2> stacks_;
    std::vector<double> solution_, work_;
    std::int64_t negative_pivots_ = 0;
};

}  // namespace gxrod
