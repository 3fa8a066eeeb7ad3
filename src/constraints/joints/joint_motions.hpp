#pragma once

#include <Eigen/Core>

#include "state/motion.hpp"

namespace gxrod {

// Vectors and matrices by the unknowns (δr, δφ) of A, then of B.
using PairRow = Eigen::Matrix<double, 1, 12>;
using PairVector = Eigen::Matrix<double, 12, 1>;
using PairMatrix = Eigen::Matrix<double, 12, 12>;
using PairJacobian = Eigen::Matrix<double, 3, 12>;

// The motions of the nodes of A and B, and their linearizations; the ground rests at the origin.
struct JointMotions {
    const NodeMotion& a;
    const NodeMotion& b;
};
struct JointLinearizations {
    const NodeLinearization& a;
    const NodeLinearization& b;
};

}  // namespace gxrod
