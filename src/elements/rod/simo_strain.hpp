#pragma once

#include "rotation/types.hpp"
#include "state/state.hpp"

// Strain and strain energy of a section whose rotation since the last accepted step is interpolated
// (Simo & Vu-Quoc 1986): everything that happens at one force point, as a function of nine numbers.
//
// Legend: r′ slope of the centreline, θ rotation vector since the last accepted step, θ′ its slope by arc
// length; Λ_n, K_n section axes and curvature at the last accepted step; Λ = exp(θ) Λ_n section axes now. Γ =
// Λᵀ r′ − Γ₀ and K = K_n + Λ_nᵀ T(θ)ᵀ θ′ − K₀ are material; N, M their resultants.
namespace gxrod {

using Vec9 = Eigen::Matrix<double, 9, 1>;
using Mat9 = Eigen::Matrix<double, 9, 9>;

struct SimoFields {
    Vec3 r_prime, theta, theta_prime;
};

// The strains of the stress-free shape that are subtracted: Γ₀ = Λ₀ᵀ r₀′ and K₀, material.
struct ReferenceStrain {
    Vec3 Gamma = Vec3::UnitX();
    Vec3 Kappa = Vec3::Zero();
};

// Γ and K stacked, material.
Vec6 compute_simo_strain(const SimoFields& fields,
                         const SectionHistory& history,
                         const ReferenceStrain& reference);

// K_n + Λ_nᵀ T(θ)ᵀ θ′, the total curvature.
Vec3 compute_total_curvature(const SimoFields& fields, const SectionHistory& history);

// Λ = exp(θ) Λ_n.
Quat compute_section_axes(const SimoFields& fields, const SectionHistory& history);

// The derivative of the strains with respect to (r′, θ, θ′).
Eigen::Matrix<double, 6, 9> compute_strain_gradient(const SimoFields& fields, const SectionHistory& history);

// The second derivative of N · Γ + M · K with respect to (r′, θ, θ′) at fixed resultants (N, M): symmetric.
Mat9 compute_geometric_hessian(const SimoFields& fields,
                               const SectionHistory& history,
                               const Vec6& resultants);

}  // namespace gxrod
