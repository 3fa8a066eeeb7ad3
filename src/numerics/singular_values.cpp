#include "numerics/singular_values.hpp"

#include <Eigen/SVD>

namespace gxrod {

Eigen::Index SingularValues::rank(double share) const {
    return values.size() == 0 ? 0 : (values.array() > share * values[0]).count();
}

SingularValues find_singular_values(const Eigen::MatrixXd& A) {
    const Eigen::BDCSVD<Eigen::MatrixXd> svd(A, Eigen::ComputeFullU);
    return {svd.singularValues(), svd.matrixU()};
}

}  // namespace gxrod
