#include "solvers/path/bordered_solve.hpp"

#include <utility>

namespace gxrod {

BorderedSolve::BorderedSolve(LinearSolver& solver,
                             const SparsePattern& pattern,
                             const std::vector<double>& values,
                             Borders borders)
    : solver_(&solver),
      pattern_(&pattern),
      values_(&values),
      borders_(std::move(borders)),
      solved_(borders_.columns) {
    for (Eigen::Index i = 0; i < solved_.cols(); ++i) {
        Eigen::VectorXd column = solved_.col(i);
        solver_->solve(column);
        solved_.col(i) = column;
    }
    schur_.compute(borders_.corner - borders_.rows.transpose() * solved_);
}

BorderedVector BorderedSolve::solve(const BorderedVector& right_hand_side) const {
    BorderedVector solution = right_hand_side;
    solver_->solve(solution.x);
    solution.y = schur_.solve(right_hand_side.y - borders_.rows.transpose() * solution.x);
    solution.x -= solved_ * solution.y;
    return solution;
}

BorderedVector BorderedSolve::solve_refined(const BorderedVector& right_hand_side) const {
    BorderedVector solution = solve(right_hand_side);
    const BorderedVector more = solve(compute_rest(right_hand_side, solution));
    solution.x += more.x;
    solution.y += more.y;
    return solution;
}

BorderedVector BorderedSolve::compute_rest(const BorderedVector& right_hand_side,
                                           const BorderedVector& solution) const {
    return {right_hand_side.x - multiply(*pattern_, *values_, solution.x) - borders_.columns * solution.y,
            right_hand_side.y - borders_.rows.transpose() * solution.x - borders_.corner * solution.y};
}

}  // namespace gxrod
