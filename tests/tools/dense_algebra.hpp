#pragma once

#include <Eigen/Core>
#include <complex>
#include <vector>

#include "linear/sparse_pattern.hpp"
#include "numerics/singular_values.hpp"
#include "rotation/types.hpp"

// What tests compare with: matrices in full and Eigen's decompositions of them, compiled once.
namespace gxrod::tools {

Eigen::MatrixXd make_dense(const SparsePattern& pattern, const std::vector<double>& values);

// The rotation that turns the x axis by the shortest way into a direction, of any length.
Quat turn_x_to(const Vec3& direction);

// A⁻¹ B.
Eigen::MatrixXd solve_dense(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B);
Eigen::MatrixXd invert(const Eigen::MatrixXd& A);
double find_determinant(const Eigen::MatrixXd& A);
// As many orthonormal columns, which span those of a square matrix.
Eigen::MatrixXd make_orthonormal(const Eigen::MatrixXd& A);

// λ of a symmetric A x = λ x, ascending.
Eigen::VectorXd find_symmetric_eigenvalues(const Eigen::MatrixXd& A);
// λ of A x = λ B x, A symmetric and B symmetric and positive definite, ascending.
Eigen::VectorXd find_symmetric_eigenvalues(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B);
// λ of A x = λ x.
std::vector<std::complex<double>> find_eigenvalues(const Eigen::MatrixXd& A);
// λ of A x = λ B x that are finite.
std::vector<std::complex<double>> find_eigenvalues(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B);
// λ of (K + λ D + λ² M) x = 0 that are finite, with Im λ ≥ 0.
std::vector<std::complex<double>> find_quadratic_eigenvalues(const Eigen::MatrixXd& K,
                                                             const Eigen::MatrixXd& D,
                                                             const Eigen::MatrixXd& M);

}  // namespace gxrod::tools
