#pragma once

#include <optional>

#include "constraints/joints/link_product.hpp"
#include "model/joint.hpp"

// The coordinates that joints leave free: what motors prescribe, and springs, dampers, drives, friction and
// limits act on. A force on a coordinate acts on B, its opposite on A, as force × gradientᵀ.
namespace gxrod {

// The right-hand turn ψ of B against A about A's axis: of a direction w on B as it is seen between e₁ and e₂
// on A, across the axis, tan ψ = (w · e₂)/(w · e₁), (J9), (J12); of any number of turns.
class JointTurn {
  public:
    explicit JointTurn(const Joint& joint);

    // ψ on the branch that is nearest to what the rotations since the last accepted step make of
    // `turn_before`, the turn then; ψ̇ and ψ̈.
    ScalarJet compute_jet(const JointMotions& motions, double turn_before) const;
    // How far that branch is from this guess, in rad: near π it could be another one.
    double compute_branch_distance(const JointMotions& motions, double turn_before) const;
    // The derivatives of ψ, as those of LinkProduct.
    PairRow compute_gradient(const JointMotions& motions) const;
    PairMatrix compute_second_derivative(const JointMotions& motions) const;
    Jet<PairRow> differentiate(const JointMotions& motions, const JointLinearizations& linearizations) const;

  private:
    double guess(const JointMotions& motions, double turn_before) const;

    Vec3 axis_;          // of A, in the global axes of t = 0
    LinkProduct x_, y_;  // w · e₁, w · e₂
};

// From A's point to B's.
LinkVector separate_points(const Joint& joint);

// The slide of B's point against A's along A's axis.
LinkProduct make_slide(const Joint& joint);

// Those of a joint.
struct JointCoordinates {
    explicit JointCoordinates(const Joint& joint);

    std::optional<JointTurn> turn;
    std::optional<LinkProduct> slide;
};

}  // namespace gxrod
