#pragma once

#include "constraints/joints/jet.hpp"
#include "constraints/joints/joint_motions.hpp"
#include "state/constraint_level.hpp"

namespace gxrod {

// The arms from the nodes of A and B to the joint's points, in the global axes of t = 0.
struct JointArms {
    Vec3 a = Vec3::Zero();
    Vec3 b = Vec3::Zero();
};

// Both sides of a joint at given motions of its nodes, shared by its equations. It has rates if the level
// needs them.
struct JointFrames {
    JointFrames(const JointMotions& motions, const JointArms& arms, ConstraintLevel level);

    // Returns Λ u for a vector u that A or B carries, given in the global axes of t = 0.
    VectorJet carry_on_a(const Vec3& u) const { return carry(R_a * u, motions.a); }
    VectorJet carry_on_b(const Vec3& u) const { return carry(R_b * u, motions.b); }

    JointMotions motions;
    ConstraintLevel level;
    Mat3 R_a, R_b;
    VectorJet arm_a, arm_b;
    VectorJet separation;  // d, from A's point to B's

  private:
    VectorJet carry(const Vec3& u, const NodeMotion& motion) const;
};

}  // namespace gxrod
