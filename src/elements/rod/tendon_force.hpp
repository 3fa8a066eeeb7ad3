#pragma once

#include "state/point_drive.hpp"

// The action of a tendon on a section that it passes through. A tendon slides along its path, d in the
// section's axes; the potential of its tension T per length of the rod is T |q|, q = Γ + K × d + d′
// (docs/theory/drives.md). Strains are total, (Γ + Γ₀, K + K₀): Γ is Λᵀ r′.
namespace gxrod {

// Computes |q|: the length of the tendon per reference length of the rod.
double compute_tendon_stretch(const TendonPull& pull, const Vec6& total_strain);

// Adds the tendon's resultants (N, M) = T (τ, d × τ), τ = q/|q|, and, unless `tangent` is nullptr, their
// derivative by the strains T Bᵀ(1 − τ⊗τ)B/|q|, B = [1, −[d]×]. Adds nothing if q vanishes.
void add_pull(const TendonPull& pull, const Vec6& total_strain, Vec6& resultants, Mat6* tangent);

}  // namespace gxrod
