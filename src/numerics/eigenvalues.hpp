#pragma once

#include <Eigen/Core>
#include <optional>

// Eigenvalue solvers, compiled once: each source that instantiates Eigen's own takes seconds longer.
namespace gxrod {

// Solutions of A x = λ x with a symmetric matrix A; only its lower triangle is read.
struct SymmetricEigen {
    Eigen::VectorXd values;   // ascending
    Eigen::MatrixXd vectors;  // columns, of length 1, at right angles
};
SymmetricEigen find_symmetric_eigen(const Eigen::MatrixXd& A);

// Finds λ of A x = λ B x, ascending, with symmetric matrices; nothing unless B is positive definite.
std::optional<Eigen::VectorXd> find_generalized_eigenvalues(const Eigen::MatrixXd& A,
                                                            const Eigen::MatrixXd& B);

// Solutions of A x = λ x with any matrix A. In a conjugate pair the value with positive imaginary part is
// first.
struct ComplexEigen {
    Eigen::VectorXcd values;
    Eigen::MatrixXcd vectors;  // columns, of length 1
};
ComplexEigen find_complex_eigen(const Eigen::MatrixXd& A);

}  // namespace gxrod
