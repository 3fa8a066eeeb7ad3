#include "constraints/joints/joint_frames.hpp"

namespace gxrod {

JointFrames::JointFrames(const JointMotions& given, const JointArms& arms, ConstraintLevel up_to)
    : motions(given),
      level(up_to),
      R_a(given.a.Lambda.toRotationMatrix()),
      R_b(given.b.Lambda.toRotationMatrix()),
      arm_a(carry_on_a(arms.a)),
      arm_b(carry_on_b(arms.b)) {
    const auto& [a, b] = motions;
    separation.value = b.r + arm_b.value - a.r - arm_a.value;
    if (level == ConstraintLevel::position) return;
    separation.rate = b.v + arm_b.rate - a.v - arm_a.rate;
    if (level == ConstraintLevel::velocity) return;
    separation.acceleration = b.a + arm_b.acceleration - a.a - arm_a.acceleration;
}

// (J2).
VectorJet JointFrames::carry(const Vec3& u, const NodeMotion& motion) const {
    VectorJet carried;
    carried.value = u;
    if (level == ConstraintLevel::position) return carried;
    carried.rate = motion.omega.cross(u);
    if (level == ConstraintLevel::velocity) return carried;
    carried.acceleration = motion.alpha.cross(u) + motion.omega.cross(carried.rate);
    return carried;
}

}  // namespace gxrod
