#pragma once

#include <Eigen/Core>

#include "linear/eigen/quadratic_problem.hpp"

namespace gxrod {

// Counts the eigenvalues of the problem within a circle about a real centre, in addition to the known ones,
// given with Im λ ≥ 0 alone: by the winding number around zero of the determinant over its known factors
// along the circle (the argument principle). Known ones outside make that easier. Returns −1 if an eigenvalue
// lies on the circle. With relaxing stiffness, the part of the circle with damping ratios above 0.87 is left
// out, near which motions creep, and the centre is positive.
std::int64_t count_more_within(const QuadraticProblem& problem,
                               double centre,
                               double radius,
                               const Eigen::VectorXcd& known);

}  // namespace gxrod
