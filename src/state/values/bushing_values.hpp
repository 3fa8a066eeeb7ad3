#pragma once

#include "state/spring_line.hpp"

namespace gxrod {

// The values of a bushing that histories show, in its axes.
struct BushingValues {
    Mat3 axes = Mat3::Identity();  // spatial: columns are x, y, z
    Vec3 displacement = Vec3::Zero();
    Vec3 turn = Vec3::Zero();
    Vec3 force = Vec3::Zero();  // force of B on it
    Vec3 moment = Vec3::Zero();
};

// Computes them from the motions `a`, `b` of the nodes that carry A and B; nullptr for the ground.
BushingValues compute_bushing_values(const Bushing& bushing, const NodeMotion* a, const NodeMotion* b);

}  // namespace gxrod
