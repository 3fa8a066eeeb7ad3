#include "numerics/symmetric_eigen.hpp"

#include <Eigen/Eigenvalues>

namespace gxrod {

SymmetricEigen find_symmetric_eigen(const Eigen::MatrixXd& A) {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(A);
    return {solver.eigenvalues(), solver.eigenvectors()};
}

}  // namespace gxrod
