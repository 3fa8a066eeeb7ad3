#include "numerics/eigenvalues.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

namespace gxrod {

SymmetricEigen find_symmetric_eigen(const Eigen::MatrixXd& A) {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(A);
    return {solver.eigenvalues(), solver.eigenvectors()};
}

std::optional<Eigen::VectorXd> find_generalized_eigenvalues(const Eigen::MatrixXd& A,
                                                            const Eigen::MatrixXd& B) {
    const Eigen::LLT<Eigen::MatrixXd> factors(B);
    if (factors.info() != Eigen::Success) return std::nullopt;
    // Of L⁻¹ A L⁻ᵀ.
    const Eigen::MatrixXd halved = factors.matrixL().solve(A);
    return find_symmetric_eigen(factors.matrixL().solve(halved.transpose())).values;
}

ComplexEigen find_complex_eigen(const Eigen::MatrixXd& A) {
    const Eigen::EigenSolver<Eigen::MatrixXd> solver(A);
    return {solver.eigenvalues(), solver.eigenvectors()};
}

}  // namespace gxrod
