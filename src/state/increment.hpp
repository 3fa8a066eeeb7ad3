#pragma once

#include "state/motion.hpp"

// The one place where a node moves on its manifold.
namespace gxrod {

// Applies a Newton increment to a trial motion: r += δr, Λ ← exp(δφ) Λ, and θ becomes the vector with
// exp(θ) = Λ Λ_nᵀ that is nearest to θ + T(θ)⁻¹ δφ; close to whole turns, where none may be near, it becomes
// θ + δφ. δφ is a spatial spin; `previous` holds Λ_n.
void apply_spin(const NodeMotion& previous, const Vec3& delta_r, const Vec3& delta_phi, NodeMotion& trial);

// Puts a trial motion at position r and at the rotation θ since `previous`: Λ = exp(θ) Λ_n. For predictors,
// and for the additive update θ ← θ + δθ that belongs to the paper's tangent (5.6).
void place(const NodeMotion& previous, const Vec3& r, const Vec3& theta, NodeMotion& trial);

}  // namespace gxrod
