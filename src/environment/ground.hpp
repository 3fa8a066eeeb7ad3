#pragma once

#include "model/surroundings.hpp"

namespace gxrod {

// The ground below, or above, a place.
struct GroundAt {
    double gap = 0.0;             // from the ground to the place along the normal; negative in the ground
    Vec3 normal = Vec3::UnitZ();  // out of the ground; the gradient of the gap if the ground is a plane there
    Vec3 gap_gradient = Vec3::UnitZ();
    Mat3 normal_gradient = Mat3::Zero();  // ∂n_i/∂x_j
};

// Finds the ground: for a plane, the distance; for a grid, (z − z_b(x, y)) n_z.
GroundAt find_ground(const Seabed& seabed, const Vec3& position);

}  // namespace gxrod
