#pragma once

#include <array>
#include <complex>
#include <optional>
#include <span>

#include "constraints/joints/link_product.hpp"
#include "model/joint.hpp"

// The coordinates that joints leave free. Motors prescribe them; springs, dampers, drives, friction and
// limits act on them. A force on a coordinate acts on B, its opposite on A, as force × gradientᵀ.
namespace gxrod {

JointArms arms_of(const Joint& joint);

// The right-hand turn ψ of B against A about A's axis, over any number of turns. It is the angle of a
// direction w on B between e₁ and e₂ on A, across the axis: tan ψ = (w · e₂)/(w · e₁), (J9), (J12). For a
// joint that holds nothing it is the twist about the axis, (J12b), which is the same for all directions
// across it. Only rotations and their rates of the frames matter.
class JointTurn {
  public:
    explicit JointTurn(const Joint& joint);

    // Computes ψ, ψ̇ and ψ̈, on the branch nearest to `turn_before`, the turn at the last accepted step, plus
    // the rotations since then.
    ScalarJet compute_jet(const JointFrames& frames, double turn_before) const;
    ScalarJet compute_jet(const JointMotions& motions, double turn_before) const;
    // Computes the distance of that branch from this guess, in rad: near π another branch could be meant.
    double compute_branch_distance(const JointMotions& motions, double turn_before) const;
    PairRow compute_gradient(const JointMotions& motions) const;

    // These do the same as in LinkProduct.
    void add_gradient(const JointFrames& frames, double factor, PairRow& row) const;
    void add_change(const JointFrames& frames,
                    const JointLinearizations& linearizations,
                    const ScalarJet& weights,
                    PairRow& row) const;
    void add_reaction(const JointFrames& frames, double multiplier, JointReaction& reaction) const;

  private:
    // A direction on B: ∇ψ is the sum of the gradients of u · w at constant u = (x e₂ − y e₁)/ρ², ∇lnρ the
    // same sum with v = (x e₁ + y e₂)/ρ².
    struct Place {
        Vec3 u, v, w;
    };
    // The direction w; for a twist also a second direction across the axis.
    std::span<const Vec3> hands() const { return std::span(hands_).first(is_twist_ ? 2 : 1); }
    Jet<std::complex<double>> compute_z(const JointFrames& frames) const;
    std::array<Place, 2> find_places(const JointFrames& frames) const;
    double guess(const JointMotions& motions, double turn_before) const;

    bool is_twist_;
    Vec3 axis_;                         // axis of A, in the global axes of t = 0, like all vectors here
    std::array<Vec3, 2> hands_;         // directions on B; on A, e₁
    std::array<Vec3, 2> across_;        // e₂ for each
    std::array<LinkProduct, 2> x_, y_;  // w · e₁, w · e₂
};

// The distance from A's point to B's along A's axis.
class JointSlide {
  public:
    explicit JointSlide(const Joint& joint);

    const LinkProduct& product() const { return product_; }
    ScalarJet compute_jet(const JointMotions& motions) const;
    PairRow compute_gradient(const JointMotions& motions) const;

  private:
    JointArms arms_;
    LinkProduct product_;
};

// The coordinates of a joint.
struct JointCoordinates {
    explicit JointCoordinates(const Joint& joint);

    std::optional<JointTurn> turn;
    std::optional<JointSlide> slide;
};

}  // namespace gxrod
