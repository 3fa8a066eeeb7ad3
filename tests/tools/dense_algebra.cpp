#include "tools/dense_algebra.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>

#include "numerics/eigenvalues.hpp"

namespace gxrod::tools {

using Complex = std::complex<double>;
using Eigen::MatrixXd, Eigen::VectorXd;

MatrixXd make_dense(const SparsePattern& pattern, const std::vector<double>& values) {
    MatrixXd dense = MatrixXd::Zero(pattern.size(), pattern.size());
    pattern.visit_entries(
        [&](std::int64_t row, std::int64_t column, std::int64_t slot) { dense(row, column) = values[slot]; });
    return dense;
}

// Of twice the half-way direction: q = (1 + x · d, x × d) before it is normalised. FromTwoVectors of Eigen
// takes a singular value decomposition, and ten seconds to compile.
Quat turn_x_to(const Vec3& direction) {
    const Vec3 d = direction.normalized();
    if (d.x() < -1.0 + 1e-12) return {0.0, 0.0, 0.0, 1.0};
    return Quat(1.0 + d.x(), 0.0, -d.z(), d.y()).normalized();
}

MatrixXd solve_dense(const MatrixXd& A, const MatrixXd& B) { return A.partialPivLu().solve(B); }

MatrixXd invert(const MatrixXd& A) { return A.inverse(); }

double find_determinant(const MatrixXd& A) { return A.determinant(); }

MatrixXd make_orthonormal(const MatrixXd& A) { return A.householderQr().householderQ(); }

VectorXd find_symmetric_eigenvalues(const MatrixXd& A) { return find_symmetric_eigen(A).values; }

VectorXd find_symmetric_eigenvalues(const MatrixXd& A, const MatrixXd& B) {
    return find_generalized_eigenvalues(A, B).value();
}

std::vector<Complex> find_eigenvalues(const MatrixXd& A) {
    const Eigen::VectorXcd values = find_complex_eigen(A).values;
    return {values.begin(), values.end()};
}

std::vector<Complex> find_eigenvalues(const MatrixXd& A, const MatrixXd& B) {
    const Eigen::GeneralizedEigenSolver<MatrixXd> solver(A, B, false);
    std::vector<Complex> finite;
    for (Eigen::Index i = 0; i < A.rows(); ++i) {
        const Complex alpha = solver.alphas()[i];
        const double beta = solver.betas()[i];
        if (std::abs(beta) > 1e-12 * std::abs(alpha)) finite.push_back(alpha / beta);
    }
    return finite;
}

std::vector<Complex> find_quadratic_eigenvalues(const MatrixXd& K, const MatrixXd& D, const MatrixXd& M) {
    const Eigen::Index n = K.rows();
    MatrixXd A = MatrixXd::Zero(2 * n, 2 * n), B = MatrixXd::Identity(2 * n, 2 * n);
    A.topRightCorner(n, n).setIdentity();
    A.bottomLeftCorner(n, n) = -K;
    A.bottomRightCorner(n, n) = -D;
    B.bottomRightCorner(n, n) = M;
    std::vector<Complex> upper = find_eigenvalues(A, B);
    std::erase_if(upper, [](Complex lambda) { return lambda.imag() < 0.0; });
    return upper;
}

}  // namespace gxrod::tools
