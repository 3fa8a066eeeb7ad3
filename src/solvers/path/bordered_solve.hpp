#pragma once

#include <Eigen/Core>
#include <Eigen/LU>

#include "linear/eigen/pencil.hpp"
#include "linear/linear_solver.hpp"

namespace gxrod {

// The borders of a matrix K: [K columns; rowsᵀ corner].
struct Borders {
    Eigen::MatrixXd columns;  // a column for each border; likewise the rows
    Eigen::MatrixXd rows;
    Eigen::MatrixXd corner;
};

struct BorderedVector {
    Eigen::VectorXd x;
    Eigen::VectorXd y;  // unknowns of the borders
};

// Solves bordered systems with the factors of K alone (block elimination): one solve for each border, once,
// and one for each right-hand side. The bordered matrix may be regular where K is nearly singular; then
// `solve_refined` recovers the digits that elimination loses (Govaerts 1991).
class BorderedSolve {
  public:
    // The solver has the factors of K; it, the pattern and the values of K must outlive this.
    BorderedSolve(LinearSolver& solver,
                  const SparsePattern& pattern,
                  const std::vector<double>& values,
                  Borders borders);

    // Returns K⁻¹ columns.
    const Eigen::MatrixXd& solved_columns() const { return solved_; }
    BorderedVector solve(const BorderedVector& right_hand_side) const;
    BorderedVector solve_refined(const BorderedVector& right_hand_side) const;

  private:
    // Computes the residual of a solution.
    BorderedVector compute_rest(const BorderedVector& right_hand_side, const BorderedVector& solution) const;

    LinearSolver* solver_;
    const SparsePattern* pattern_;
    const std::vector<double>* values_;
    Borders borders_;
    Eigen::MatrixXd solved_;
    Eigen::PartialPivLU<Eigen::MatrixXd> schur_;  // factors of corner − rowsᵀ K⁻¹ columns
};

}  // namespace gxrod
