#pragma once

#include <Eigen/Core>

namespace gxrod {

// A x = λ x of a symmetric matrix, whose lower triangle is read.
struct SymmetricEigen {
    Eigen::VectorXd values;   // ascending
    Eigen::MatrixXd vectors;  // columns, of length 1, at right angles
};

// Compiled once: Eigen's own solvers take seconds of each source that instantiates them.
SymmetricEigen find_symmetric_eigen(const Eigen::MatrixXd& A);

}  // namespace gxrod
