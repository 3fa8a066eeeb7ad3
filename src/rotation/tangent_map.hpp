#pragma once

#include "rotation/types.hpp"

// The tangent map T(φ) of the rotation vector, which takes a rate of φ to a spin: ω = T(φ) φ̇ (Rubin
// 2007, 3.6a), its inverse and their derivatives. T(φ)ᵀ = T(−φ), and exp(φ)ᵀ T(φ) = T(φ)ᵀ.
namespace gxrod {

// T(φ) = a I + b φ⊗φ + c [φ]×, (3.6a).
Mat3 tangent_map(const Vec3& phi);

// T(φ)⁻¹ = I − ½ [φ]× + d [φ]×², (3.7a). Singular at |φ| = 2π, 4π, …
Mat3 tangent_map_inverse(const Vec3& phi);

// The derivative of T(φ) v with respect to φ at fixed v: the matrix Y with δ(T v) = Y δφ.
Mat3 tangent_map_derivative(const Vec3& phi, const Vec3& v);

// The derivative of T(φ)ᵀ v with respect to φ at fixed v.
Mat3 tangent_map_transpose_derivative(const Vec3& phi, const Vec3& v);

// The derivative of T(φ)⁻¹ v with respect to φ at fixed v.
Mat3 tangent_map_inverse_derivative(const Vec3& phi, const Vec3& v);

// The derivative of T(φ)⁻ᵀ v with respect to φ at fixed v.
Mat3 tangent_map_inverse_transpose_derivative(const Vec3& phi, const Vec3& v);

// The Hessian (symmetric) of the scalar u · T(φ) v with respect to φ at fixed u and v.
Mat3 tangent_map_hessian(const Vec3& phi, const Vec3& u, const Vec3& v);

}  // namespace gxrod
