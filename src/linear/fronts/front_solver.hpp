#pragma once

#include <Eigen/Core>

#include "linear/fronts/front_layout.hpp"

namespace gxrod {

// LU by dense fronts over blocks of unknowns, such as those of a node, for systems whose blocks fill in:
// those of junctions. Pivots are sought within no block, so the caller must check the residual. The
// pattern must be symmetric and have its diagonal.
class FrontSolver {
  public:
    explicit FrontSolver(const SparsePattern& pattern);

    // False if a pivot vanishes.
    bool factorize(const std::vector<double>& values);
    // Of a factorization.
    double estimate_flops() const;
    // Of the last regular factorization.
    std::int64_t negative_pivots() const { return negative_pivots_; }
    // Replaces the right-hand side by the solution. After a regular factorization only.
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
