#include "elements/rod/simo_strain.hpp"

#include "rotation/rotation_map.hpp"
#include "rotation/tangent_map.hpp"

namespace gxrod {

Vec3 compute_total_curvature(const SimoFields& fields, const SectionHistory& history) {
    const Vec3 spun = tangent_map(fields.theta).transpose() * fields.theta_prime;
    return history.K + history.Lambda.conjugate() * spun;
}

Quat compute_section_axes(const SimoFields& fields, const SectionHistory& history) {
    return exp_quaternion(fields.theta) * history.Lambda;
}

Vec6 compute_simo_strain(const SimoFields& fields,
                         const SectionHistory& history,
                         const ReferenceStrain& reference) {
    const Quat Lambda = compute_section_axes(fields, history);
    Vec6 strain;
    strain << Lambda.conjugate() * fields.r_prime - reference.Gamma,
        compute_total_curvature(fields, history) - reference.Kappa;
    return strain;
}

Eigen::Matrix<double, 6, 9> compute_strain_gradient(const SimoFields& fields, const SectionHistory& history) {
    const Mat3 T = tangent_map(fields.theta);
    const Mat3 Lambda_n = history.Lambda.toRotationMatrix();
    const Mat3 Lambda_transposed = compute_section_axes(fields, history).conjugate().toRotationMatrix();
    Eigen::Matrix<double, 6, 9> gradient = Eigen::Matrix<double, 6, 9>::Zero();
    gradient.block<3, 3>(0, 0) = Lambda_transposed;
    gradient.block<3, 3>(0, 3) = Lambda_transposed * spin(fields.r_prime) * T;
    gradient.block<3, 3>(3, 3) =
        Lambda_n.transpose() * tangent_map_transpose_derivative(fields.theta, fields.theta_prime);
    gradient.block<3, 3>(3, 6) = Lambda_n.transpose() * T.transpose();
    return gradient;
}

Mat9 compute_geometric_hessian(const SimoFields& fields,
                               const SectionHistory& history,
                               const Vec6& resultants) {
    const Mat3 T = tangent_map(fields.theta);
    const Vec3 n = compute_section_axes(fields, history) * resultants.head<3>();
    const Vec3 m_n = history.Lambda * resultants.tail<3>();  // M turned to the axes of the last step
    const Mat3 spin_n = spin(n);
    const Mat3 spin_r = spin(fields.r_prime);
    Mat9 hessian = Mat9::Zero();
    hessian.block<3, 3>(0, 3) = -spin_n * T;
    hessian.block<3, 3>(3, 0) = hessian.block<3, 3>(0, 3).transpose();
    hessian.block<3, 3>(3, 3) = tangent_map_transpose_derivative(fields.theta, n.cross(fields.r_prime)) +
                                T.transpose() * spin_r * spin_n * T +
                                tangent_map_hessian(fields.theta, fields.theta_prime, m_n);
    hessian.block<3, 3>(6, 3) = tangent_map_derivative(fields.theta, m_n);
    hessian.block<3, 3>(3, 6) = hessian.block<3, 3>(6, 3).transpose();
    return hessian;
}

}  // namespace gxrod
