#include "cross_section/stress_measures.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>

namespace gxrod {

double compute_von_mises(const Vec6& stress) {
    const double d12 = stress[0] - stress[1], d23 = stress[1] - stress[2], d31 = stress[2] - stress[0];
    return std::sqrt(0.5 * (d12 * d12 + d23 * d23 + d31 * d31) + 3.0 * stress.tail<3>().squaredNorm());
}

Vec3 compute_principal_stresses(const Vec6& stress) {
    Mat3 tensor;
    tensor << stress[0], stress[5], stress[4],  //
        stress[5], stress[1], stress[3],        //
        stress[4], stress[3], stress[2];
    return Eigen::SelfAdjointEigenSolver<Mat3>(tensor, Eigen::EigenvaluesOnly).eigenvalues().reverse();
}

}  // namespace gxrod
