#pragma once

#include "rotation/types.hpp"

namespace gxrod {

// A velocity u at a place, its rate ∂u/∂t there, and the gradients of both, ∂u_i/∂x_j.
struct FlowAt {
    Vec3 velocity = Vec3::Zero();
    Vec3 acceleration = Vec3::Zero();
    Mat3 velocity_gradient = Mat3::Zero();
    Mat3 acceleration_gradient = Mat3::Zero();
};

}  // namespace gxrod
