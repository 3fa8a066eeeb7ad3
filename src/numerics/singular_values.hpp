#pragma once

#include <Eigen/Core>

namespace gxrod {

// A = U Σ Vᵀ; those of Aᵀ have V for U.
struct SingularValues {
    Eigen::VectorXd values;  // descending
    Eigen::MatrixXd left;    // U, square

    // How many values exceed a share of the largest.
    Eigen::Index rank(double share) const;
};

// Compiled once, as SymmetricEigen.
SingularValues find_singular_values(const Eigen::MatrixXd& A);

}  // namespace gxrod
