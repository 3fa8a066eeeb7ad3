#pragma once

#include <Eigen/Core>
#include <optional>

// Compiled once: Eigen's own solvers take seconds of each source that instantiates them.
namespace gxrod {

// A x = λ x of a symmetric matrix, whose lower triangle is read.
struct SymmetricEigen {
    Eigen::VectorXd values;   // ascending
    Eigen::MatrixXd vectors;  // columns, of length 1, at right angles
};
SymmetricEigen find_symmetric_eigen(const Eigen::MatrixXd& A);

// λ of A x = λ B x, ascending, of symmetric matrices; none unless B is positive definite.
std::optional<Eigen::VectorXd> find_generalized_eigenvalues(const Eigen::MatrixXd& A,
                                                            const Eigen::MatrixXd& B);

// A x = λ x of any matrix; of a pair of complex values that with a positive imaginary part comes first.
struct ComplexEigen {
    Eigen::VectorXcd values;
    Eigen::MatrixXcd vectors;  // columns, of length 1
};
ComplexEigen find_complex_eigen(const Eigen::MatrixXd& A);

}  // namespace gxrod
