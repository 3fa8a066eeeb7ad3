#pragma once

#include <Eigen/Geometry>

#include "rotation/cross_products.hpp"

// The inertia of rotation alone. Real is double, or several doubles at once.
//
// Legend: Lambda rotation since t = 0, J = Λ J₀ Λᵀ inertia about the node, omega and alpha angular velocity
// and acceleration, all spatial.
namespace gxrod {

template <class Real>
struct RotaryInertia {
    using Vec3 = Eigen::Matrix<Real, 3, 1>;
    using Mat3 = Eigen::Matrix<Real, 3, 3>;

    Mat3 J;

    // J₀ is constant in the global axes of t = 0.
    RotaryInertia(const Mat3& J_0, const Eigen::Quaternion<Real>& Lambda) {
        const Mat3 R = Lambda.toRotationMatrix();
        const Mat3 R_J = R * J_0;
        J.noalias() = R_J * R.transpose();
    }

    // Computes J α + ω × J ω.
    Vec3 compute_moment(const Vec3& omega, const Vec3& alpha) const {
        return J * alpha + omega.cross(J * omega);
    }

    // Computes its derivative by δφ, with δω = d_omega δφ, δα = d_alpha δφ: J d_alpha + (ω̂ J − [Jω]×)
    // d_omega + placement A, where A of (5.6), Rubin (2007), is the effect of turning the body.
    Mat3 compute_tangent(const Vec3& omega,
                         const Vec3& alpha,
                         const Real& placement,
                         const Mat3& d_omega,
                         const Mat3& d_alpha) const {
        const Vec3 J_omega = J * omega;
        const Mat3 gyroscopic = cross_columns(omega, J) - cross_matrix(J_omega);
        const Mat3 by_turning = cross_rows(J, alpha) - cross_matrix<Real>(J * alpha) +
                                cross_columns<Real>(omega, cross_rows(J, omega) - cross_matrix(J_omega));
        Mat3 tangent = J * d_alpha;
        tangent.noalias() += gyroscopic * d_omega;
        return tangent + placement * by_turning;
    }

    // Compute J ω, and its derivative by δφ.
    Vec3 compute_momentum(const Vec3& omega) const { return J * omega; }
    Mat3 compute_momentum_tangent(const Vec3& omega, const Real& placement, const Mat3& d_omega) const {
        return J * d_omega + placement * (cross_rows(J, omega) - cross_matrix<Real>(J * omega));
    }
};

}  // namespace gxrod
