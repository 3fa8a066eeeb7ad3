#pragma once

#include <Eigen/Core>

namespace gxrod {

// Singular values of A = U Σ Vᵀ. Pass Aᵀ to get V in place of U.
struct SingularValues {
    Eigen::VectorXd values;  // descending
    Eigen::MatrixXd left;    // U, square

    // Counts the values that exceed a share of the largest.
    Eigen::Index rank(double share) const;
};

// Computes them; compiled once, as the solvers of eigenvalues.hpp.
SingularValues find_singular_values(const Eigen::MatrixXd& A);

}  // namespace gxrod
