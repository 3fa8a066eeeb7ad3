#pragma once

#include "constraints/joints/jet.hpp"

// What the equations of joints are made of: vectors on the two sides or between them, and products of two.
namespace gxrod {

// A vector c + Λ_A a + Λ_B b + σ (r_B − r_A), (J1): fixed in space, carried by A, carried by B, or from A's
// point to B's; a and b in the global axes of t = 0.
struct LinkVector {
    Vec3 in_space = Vec3::Zero();  // c
    Vec3 on_a = Vec3::Zero();
    Vec3 on_b = Vec3::Zero();
    double span = 0.0;  // σ, 0 or 1

    bool is_fixed() const { return span == 0.0 && on_a.isZero(0.0) && on_b.isZero(0.0); }
};

// u · w of two such vectors. Derivatives by (δr, δφ) of A and B are those by displacement and spatial spin.
class LinkProduct {
  public:
    LinkProduct() = default;
    LinkProduct(const LinkVector& first, const LinkVector& second) : first_(first), second_(second) {}

    ScalarJet compute_jet(const JointMotions& motions) const;
    PairRow compute_gradient(const JointMotions& motions) const;
    // ∂(gradientᵀ)/∂(δr, δφ), unsymmetric, as spins do not commute.
    PairMatrix compute_second_derivative(const JointMotions& motions) const;
    // The derivatives of the jet by Newton's unknowns.
    Jet<PairRow> differentiate(const JointMotions& motions, const JointLinearizations& linearizations) const;

  private:
    LinkVector first_, second_;
};

}  // namespace gxrod
