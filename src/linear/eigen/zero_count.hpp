#pragma once

#include <Eigen/Core>

#include "linear/eigen/quadratic_problem.hpp"

namespace gxrod {

// How many eigenvalues of the problem lie within a circle about a real centre, in addition to the known ones,
// given with Im λ ≥ 0 alone: by how often the determinant over its known factors turns around zero on the way
// along the circle (the argument principle). Known ones outside make that easier. −1: not known, because an
// eigenvalue lies on the circle. Where something relaxes, the part of the circle with damping ratios above
// 0.87 is left out, next to which motions creep, and the centre is positive.
std::int64_t count_more_within(const QuadraticProblem& problem,
                               double centre,
                               double radius,
                               const Eigen::VectorXcd& known);

}  // namespace gxrod
