#pragma once

#include "rotation/types.hpp"

namespace gxrod {

// A point that a node carries, or a point fixed in space.
struct Anchor {
    int node = -1;  // −1: the ground
    // The arm from the node to the point, global axes at t = 0; for the ground the point itself.
    Vec3 arm = Vec3::Zero();

    bool is_ground() const { return node < 0; }
};

}  // namespace gxrod
