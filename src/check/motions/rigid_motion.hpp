#pragma once

#include <vector>

#include "model/parts.hpp"
#include "state/state.hpp"

namespace gxrod {

// A small motion of a part as a rigid body: a displacement of a point and a rotation about it; global
// components.
struct RigidMotion {
    Vec3 displacement = Vec3::Zero();
    Vec3 rotation = Vec3::Zero();
    Vec3 point = Vec3::Zero();

    Vec3 displacement_at(const Vec3& r) const { return displacement + rotation.cross(r - point); }
};

// Computes the direction of a motion per node (δr over `length`, δφ), at the trial positions of the state;
// zero outside the part.
std::vector<Vec6> compute_direction(const RigidMotion& motion,
                                    const ModelPart& part,
                                    const State& state,
                                    double length);

// The rigid motion nearest to a direction on the part, and the remainder of the direction, both over the
// part's nodes: 0 if the direction is rigid there.
struct RigidFit {
    RigidMotion motion;
    double remainder = 0.0;
};
RigidFit fit_rigid_motion(const std::vector<Vec6>& direction,
                          const ModelPart& part,
                          const State& state,
                          double length);

Vec3 compute_centre(const ModelPart& part, const State& state);

}  // namespace gxrod
