#include "elements/rod/section_strain.hpp"

#include "rotation/rotation_map.hpp"
#include "rotation/tangent_map.hpp"

namespace gxrod {

Vec3 compute_total_curvature(const SectionFields& fields, const SectionHistory& history) {
    const Vec3 spun = tangent_map(fields.theta).transpose() * fields.theta_prime;
    return history.K + history.Lambda.conjugate() * spun;
}

Quat compute_section_axes(const Vec3& theta, const SectionHistory& history) {
    return exp_quaternion(theta) * history.Lambda;
}

Vec6 compute_strain(const SectionFields& fields,
                    const SectionHistory& history,
                    const ReferenceStrain& reference) {
    const Quat Lambda = compute_section_axes(fields.theta, history);
    Vec6 strain;
    strain << Lambda.conjugate() * fields.r_prime - reference.Gamma,
        compute_total_curvature(fields, history) - reference.Kappa;
    return strain;
}

StrainGradient compute_strain_gradient(const SectionFields& fields, const SectionHistory& history) {
    const Mat3 T = tangent_map(fields.theta);
    const Mat3 Lambda_n = history.Lambda.toRotationMatrix();
    const Mat3 Lambda_transposed = compute_section_axes(fields.theta, history).conjugate().toRotationMatrix();
    StrainGradient gradient = StrainGradient::Zero();
    gradient.block<3, 3>(0, 0) = Lambda_transposed;
    gradient.block<3, 3>(0, 3) = Lambda_transposed * spin(fields.r_prime) * T;
    gradient.block<3, 3>(3, 3) =
        Lambda_n.transpose() * tangent_map_transpose_derivative(fields.theta, fields.theta_prime);
    gradient.block<3, 3>(3, 6) = Lambda_n.transpose() * T.transpose();
    return gradient;
}

Mat9 compute_geometric_hessian(const SectionFields& fields,
                               const SectionHistory& history,
                               const Vec6& resultants) {
    const Mat3 T = tangent_map(fields.theta);
    const Vec3 n = compute_section_axes(fields.theta, history) * resultants.head<3>();
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

namespace {

// The derivative of T(θ) along θ̇: a matrix.
Mat3 compute_tangent_map_rate(const Vec3& theta, const Vec3& theta_dot) {
    Mat3 rate;
    for (int k = 0; k < 3; ++k) rate.col(k) = tangent_map_derivative(theta, Vec3::Unit(k)) * theta_dot;
    return rate;
}

// The derivative of (∂(T(θ)ᵀ v)/∂θ) θ̇ with respect to θ.
Mat3 compute_second_derivative(const Vec3& theta, const Vec3& v, const Vec3& theta_dot) {
    Mat3 derivative;
    for (int k = 0; k < 3; ++k) {
        derivative.row(k) = (tangent_map_hessian(theta, v, Vec3::Unit(k)) * theta_dot).transpose();
    }
    return derivative;
}

}  // namespace

StrainGradient compute_strain_rate_gradient(const SectionFields& fields,
                                            const SectionFields& rates,
                                            const SectionHistory& history) {
    const Vec3& theta = fields.theta;
    const Mat3 T = tangent_map(theta);
    const Mat3 Lambda_n_transposed = history.Lambda.conjugate().toRotationMatrix();
    const Mat3 Lambda_transposed = compute_section_axes(fields.theta, history).conjugate().toRotationMatrix();
    const Vec3 omega = T * rates.theta;
    const Vec3 y = rates.r_prime + fields.r_prime.cross(omega);  // Γ̇ = Λᵀ y
    StrainGradient gradient = StrainGradient::Zero();
    gradient.block<3, 3>(0, 0) = -Lambda_transposed * spin(omega);
    gradient.block<3, 3>(0, 3) =
        Lambda_transposed * (spin(y) * T + spin(fields.r_prime) * tangent_map_derivative(theta, rates.theta));
    gradient.block<3, 3>(3, 3) =
        Lambda_n_transposed * (compute_second_derivative(theta, fields.theta_prime, rates.theta) +
                               tangent_map_transpose_derivative(theta, rates.theta_prime));
    gradient.block<3, 3>(3, 6) =
        Lambda_n_transposed * compute_tangent_map_rate(theta, rates.theta).transpose();
    return gradient;
}

}  // namespace gxrod
