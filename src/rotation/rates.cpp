#include "rotation/rates.hpp"

#include <cassert>
#include <cmath>
#include <numbers>

#include "rotation/coefficients.hpp"
#include "rotation/rotation_map.hpp"

namespace gxrod {
namespace {

// Within this of 0 or π an angle counts as singular: log is not accurate enough there to give the axis, or
// its sign, from the rotation alone.
constexpr double singular_angle = 1e-14;

// The rotation vector of Λ. At π the sign of the axis follows (3.12–3.13): the angle is about to fall.
Vec3 compute_moving_log(const Mat3& Lambda, const Vec3& omega, const Vec3& omega_dot) {
    Vec3 phi = log(Lambda);
    const double angle = phi.norm();
    if (angle < std::numbers::pi - singular_angle) return phi;
    const double velocity = phi.dot(omega);
    const bool turns = std::abs(velocity) > singular_angle * angle * omega.norm();
    const double rate = turns ? velocity : phi.dot(omega_dot);
    if (rate > 0.0) phi = -phi;
    return phi;
}

}  // namespace

Vec3 angular_velocity(const Vec3& phi, const Vec3& phi_dot) {
    const double angle = phi.norm();
    return coefficients::a(angle) * phi_dot + (coefficients::b(angle) * phi.dot(phi_dot)) * phi +
           coefficients::c(angle) * phi.cross(phi_dot);
}

// With Φ Φ̇ = φ·φ̇, the rates of the coefficients are ȧ = a1 (φ·φ̇) and so on.
Vec3 angular_acceleration(const Vec3& phi, const Vec3& phi_dot, const Vec3& phi_ddot) {
    const double angle = phi.norm();
    const double along = phi.dot(phi_dot);
    const double b = coefficients::b(angle);
    const double along_phi = coefficients::b1(angle) * along * along + b * phi_dot.squaredNorm();
    const double along_phi_dot = (coefficients::a1(angle) + b) * along;
    return angular_velocity(phi, phi_ddot) + along_phi * phi + along_phi_dot * phi_dot +
           (coefficients::c1(angle) * along) * phi.cross(phi_dot);
}

AngleRates angle_rates(const Vec3& phi, const Vec3& omega, const Vec3& omega_dot) {
    const double angle = phi.stableNorm();
    assert(angle > 0.0 && angle < 2.0 * std::numbers::pi);
    const Vec3 axis = phi / angle;
    const double across = axis.cross(omega).squaredNorm();
    return {axis.dot(omega), axis.dot(omega_dot) + 0.5 * across / std::tan(0.5 * angle)};
}

// φ̇ = T⁻¹ ω and its rate, which equals (3.7b) and, unlike the split into Φ and f, is regular at φ = 0.
RotationVectorMotion rotation_vector_motion(const Vec3& phi, const Vec3& omega, const Vec3& omega_dot) {
    const double angle = phi.norm();
    assert(angle < 2.0 * std::numbers::pi);
    const double d = coefficients::d(angle);
    const double d1 = coefficients::d1(angle);
    const Vec3 across = phi.cross(omega);
    const Vec3 phi_dot = omega - 0.5 * across + d * phi.cross(across);
    const Vec3 across_rate = phi.cross(omega_dot) + phi_dot.cross(omega);
    const Vec3 phi_ddot = omega_dot - 0.5 * across_rate + (d1 * phi.dot(phi_dot)) * phi.cross(across) +
                          d * (phi_dot.cross(across) + phi.cross(across_rate));
    return {phi, phi_dot, phi_ddot};
}

Vec3 rotation_axis(const Mat3& Lambda, const Vec3& omega, const Vec3& omega_dot) {
    const Vec3 phi = compute_moving_log(Lambda, omega, omega_dot);
    if (phi.norm() > singular_angle) return phi.normalized();
    const bool turns = omega.stableNorm() > 0.0;
    return (turns ? omega : omega_dot).stableNormalized();
}

RotationVectorMotion rotation_vector_motion(const Mat3& Lambda, const Vec3& omega, const Vec3& omega_dot) {
    return rotation_vector_motion(compute_moving_log(Lambda, omega, omega_dot), omega, omega_dot);
}

}  // namespace gxrod
