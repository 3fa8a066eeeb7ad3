#pragma once

#include "rotation/types.hpp"

// Relations of the rates of the rotation vector to angular velocity and acceleration (Rubin 2007, sections 2
// and 3). Vectors are spatial; φ in rad, ω in rad/s, ω̇ in rad/s².
namespace gxrod {

// Computes ω of a rotation vector φ with rate φ̇, (3.6a).
Vec3 angular_velocity(const Vec3& phi, const Vec3& phi_dot);

// Computes ω̇ of a rotation vector φ with rates φ̇ and φ̈, (3.6b).
Vec3 angular_acceleration(const Vec3& phi, const Vec3& phi_dot, const Vec3& phi_ddot);

struct AngleRates {
    double first;   // Φ̇
    double second;  // Φ̈
};

// Computes Φ̇ and Φ̈ of the angle Φ = |φ|, (3.8). Needs 0 < Φ < 2π.
AngleRates angle_rates(const Vec3& phi, const Vec3& omega, const Vec3& omega_dot);

struct RotationVectorMotion {
    Vec3 phi;
    Vec3 phi_dot;
    Vec3 phi_ddot;
};

// Computes φ̇ and φ̈ at a regular φ, 0 ≤ |φ| < 2π, (3.7a,b); the limit (3.11) at φ = 0.
RotationVectorMotion rotation_vector_motion(const Vec3& phi, const Vec3& omega, const Vec3& omega_dot);

// Computes the unit axis f of the rotation vector, also at the two singular angles: at Φ = 0 the direction in
// which φ is about to leave, (3.11); at Φ = π the axis about which the angle is about to fall below π,
// (3.12–3.13). The zero vector if nothing moves at Φ = 0.
Vec3 rotation_axis(const Mat3& Lambda, const Vec3& omega, const Vec3& omega_dot);

// Computes φ, φ̇ and φ̈ of a body whose rotation tensor is Λ, |φ| ≤ π, with both singular limits (3.11–3.13).
RotationVectorMotion rotation_vector_motion(const Mat3& Lambda, const Vec3& omega, const Vec3& omega_dot);

}  // namespace gxrod
