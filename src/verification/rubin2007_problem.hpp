#pragma once

#include "model/model.hpp"

// The test problem of Rubin (2007), section 6: an axisymmetric body at rest, turned by a moment about e₃
// through six turns of precession and one of spin, back to rest in the orientation it began with. SI units; Ω
// = 1 rad/s.
namespace gxrod::rubin2007 {

inline constexpr double inertia_1 = 1.0;        // transverse, kg m²
inline constexpr double inertia_3 = 0.75;       // axial
inline constexpr double momentum_scale = 12.0;  // H₀, from H₀/(2 I₁ Ω) = 6
extern const double tilt;                       // θ₀ = π/3, about e₂
extern const double period;                     // 2π/Ω

// M(t) = ½ Ω H₀ sin(Ωt) e₃.
Vec3 moment(double time);
// Λ(t) = Rz(ψ) Ry(θ₀) Rz(β).
Mat3 exact_rotation(double time);
// H(t) = ½ H₀ (1 − cos Ωt) e₃.
Vec3 exact_momentum(double time);
// T(t) = ⅛ H₀² (sin²θ₀/I₁ + cos²θ₀/I₃)(1 − cos Ωt)².
double exact_kinetic_energy(double time);
// ω(t) = J⁻¹ H.
Vec3 exact_angular_velocity(double time);

// Makes a model of only the body and its moment.
Model make_model();

// The errors (6.14): orientation by the Frobenius norm, momentum and energy relative to their values at t =
// π/Ω.
struct Errors {
    double orientation = 0.0;
    double momentum = 0.0;
    double energy = 0.0;
};
Errors compute_errors(double time, const Mat3& rotation, const Vec3& momentum, double kinetic_energy);

}  // namespace gxrod::rubin2007
