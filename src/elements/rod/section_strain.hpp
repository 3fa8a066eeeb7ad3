#pragma once

#include "rotation/types.hpp"
#include "state/state.hpp"

// Strain and strain energy of a section whose rotation since a known attitude is interpolated: the mechanics
// of one force point, as a function of nine numbers. The element `simo` starts from the section at the last
// accepted step, the element `objective` from its own triad.
//
// Legend: r′ slope of the centreline, θ rotation vector since the known attitude, θ′ its slope by arc length;
// Λ_n, K_n known section axes and curvature; Λ = exp(θ) Λ_n section axes now. Γ = Λᵀ r′ − Γ₀ and K = K_n +
// Λ_nᵀ T(θ)ᵀ θ′ − K₀ are material; N, M their resultants.
namespace gxrod {

using Vec9 = Eigen::Matrix<double, 9, 1>;
using Mat9 = Eigen::Matrix<double, 9, 9>;
using StrainGradient = Eigen::Matrix<double, 6, 9>;

struct SectionFields {
    Vec3 r_prime, theta, theta_prime;
};

// The strains of the stress-free shape that are subtracted: Γ₀ = Λ₀ᵀ r₀′ and K₀, material.
struct ReferenceStrain {
    Vec3 Gamma = Vec3::UnitX();
    Vec3 Kappa = Vec3::Zero();
};

// Returns Γ and K stacked, material.
Vec6 compute_strain(const SectionFields& fields,
                    const SectionHistory& history,
                    const ReferenceStrain& reference);

// Returns the total curvature K_n + Λ_nᵀ T(θ)ᵀ θ′.
Vec3 compute_total_curvature(const SectionFields& fields, const SectionHistory& history);

// Returns Λ = exp(θ) Λ_n.
Quat compute_section_axes(const Vec3& theta, const SectionHistory& history);

// Computes the derivative of the strains by (r′, θ, θ′).
StrainGradient compute_strain_gradient(const SectionFields& fields, const SectionHistory& history);

// Computes the second derivative of N · Γ + M · K by (r′, θ, θ′) at fixed resultants (N, M): symmetric.
Mat9 compute_geometric_hessian(const SectionFields& fields,
                               const SectionHistory& history,
                               const Vec6& resultants);

// Computes the derivative by (r′, θ, θ′) of the strain rates compute_strain_gradient × rates, at fixed rates
// of (r′, θ, θ′).
StrainGradient compute_strain_rate_gradient(const SectionFields& fields,
                                            const SectionFields& rates,
                                            const SectionHistory& history);

}  // namespace gxrod
