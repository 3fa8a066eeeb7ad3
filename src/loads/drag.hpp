#pragma once

#include "rotation/types.hpp"

// Drag that is quadratic in u, the velocity of the fluid relative to a rod or body, in its axes.
namespace gxrod {

// Computes the drag of a rod by the cross-flow principle: factors · (|u_x| u_x, u_n u_y, u_n u_z), u_n =
// √(u_y² + u_z²).
Vec3 compute_cross_flow_drag(const Vec3& factors, const Vec3& u);
Mat3 compute_cross_flow_drag_derivative(const Vec3& factors, const Vec3& u);

// Computes the drag of a body: factors · |u| u_i along each axis, so that equal factors give a drag along u.
Vec3 compute_body_drag(const Vec3& factors, const Vec3& u);
Mat3 compute_body_drag_derivative(const Vec3& factors, const Vec3& u);

}  // namespace gxrod
