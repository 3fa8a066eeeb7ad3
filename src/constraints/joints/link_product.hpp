#pragma once

#include "constraints/joints/joint_reaction.hpp"

// The terms of the equations of joints: vectors on the two sides or between them, and products of two.
namespace gxrod {

// A vector that is fixed in space, that A or B carries, or that leads from A's point to B's, (J1).
struct LinkVector {
    enum class Kind { fixed, on_a, on_b, separation };
    Kind kind = Kind::fixed;
    Vec3 vector = Vec3::Zero();  // in the global axes of t = 0; not used for the separation
};

// The product u · w of two such vectors: u fixed or on A and w on B or the separation, or both the
// separation. Derivatives by (δr, δφ) of A and B are derivatives by displacement and spatial spin.
class LinkProduct {
  public:
    LinkProduct() = default;
    LinkProduct(const LinkVector& u, const LinkVector& w) : u_(u), w_(w) {}

    // Computes the product with the rates of the frames' level.
    ScalarJet compute_jet(const JointFrames& frames) const;
    // Adds the factor times the gradient.
    void add_gradient(const JointFrames& frames, double factor, PairRow& row) const;
    // Adds the derivatives of the jet's values by Newton's unknowns, each times its weight. The frames have
    // accelerations.
    void add_change(const JointFrames& frames,
                    const JointLinearizations& linearizations,
                    const ScalarJet& weights,
                    PairRow& row) const;
    // Adds the reaction for a multiplier.
    void add_reaction(const JointFrames& frames, double multiplier, JointReaction& reaction) const;

  private:
    LinkVector u_, w_;
};

}  // namespace gxrod
