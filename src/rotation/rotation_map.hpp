#pragma once

#include "rotation/types.hpp"

// Conversions between rotation vectors, rotation tensors and quaternions. Angles in radians; every vector is
// in the fixed frame. Equation numbers: Rubin (2007).
namespace gxrod {

// [a]×, the matrix with [a]× b = a × b.
Mat3 spin(const Vec3& a);

// Returns the axial vector of the skew part of A: axial(spin(a)) = a.
Vec3 axial(const Mat3& A);

// Λ(φ), the rotation by |φ| about φ, (3.2).
Mat3 exp_matrix(const Vec3& phi);

// Returns the same rotation as a unit quaternion.
Quat exp_quaternion(const Vec3& phi);

// Computes the rotation vector φ, |φ| ≤ π, of a rotation tensor, (3.5); near π the axis comes from the
// symmetric part, (3.12). Exactly at π the result is either of ±φ.
Vec3 log(const Mat3& Lambda);

// Computes the rotation vector φ, |φ| ≤ π, of a unit quaternion of either sign.
Vec3 log(const Quat& q);

// Computes the rotation vector of the rotation q that is nearest to `guess`: log(q) plus the whole turns
// about its axis that bring it closest. For |guess| of any size.
Vec3 log_nearest(const Quat& q, const Vec3& guess);

// Computes the rotation vector of `second` after `first`: exp(result) = exp(second) exp(first), |result| ≤ π.
Vec3 compose(const Vec3& second, const Vec3& first);

}  // namespace gxrod
