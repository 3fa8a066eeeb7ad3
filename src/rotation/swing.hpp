#pragma once

#include <array>

#include "rotation/types.hpp"

// The swing of one direction into another, and the twist about both by any angle.
//
// Legend: x, y unit vectors with spins ω_x, ω_y; c = x · y = cos θ, p = x × y; f = θ/sin θ. The swing is s =
// f p. The twist turns at b · (ω_y − ω_x), b = (x + y)/(1 + c): at Ω where y spins about itself at Ω.
namespace gxrod {

// A vector and its derivatives by spins of x and of y: δv = by[0] δφ_x + by[1] δφ_y.
struct PairedVector {
    Vec3 v = Vec3::Zero();
    std::array<Mat3, 2> by{Mat3::Zero(), Mat3::Zero()};
};

// Computes the swing s, the rotation vector that takes x into y the shortest way; not a number if they are
// opposite.
PairedVector compute_swing(const Vec3& x, const Vec3& y);

// Computes the rate of the swing, by[0] ω_x + by[1] ω_y, and its derivatives by δφ at fixed spins.
PairedVector compute_swing_rate(const Vec3& x, const Vec3& y, const Vec3& omega_x, const Vec3& omega_y);

// Computes the derivatives of by[i]ᵀ m of the swing with respect to φ_x and φ_y at fixed m: [i][0] and
// [i][1].
std::array<std::array<Mat3, 2>, 2> differentiate_swing_moments(const Vec3& x, const Vec3& y, const Vec3& m);

// Computes the direction b of the twist.
PairedVector compute_twist_direction(const Vec3& x, const Vec3& y);

}  // namespace gxrod
