#pragma once

#include <Eigen/Core>
#include <vector>

#include "loads/distributed_load.hpp"
#include "loads/loaded_element.hpp"
#include "model/point_motion.hpp"
#include "state/motion.hpp"

// Loads that depend on how the points on which they act move.
namespace gxrod {

// The derivative of force and moment by position, velocity, rotation vector and spin, in this order.
using MotionDerivative = Eigen::Matrix<double, 6, 12>;

// Computes what (S19) needs of it by central differences; on a kink, the mean of both sides. Columns that
// nothing depends on are zero: with `linearization.placement` zero those by position and rotation, with
// `rate` zero those by velocity and spin. `length` is the model's length, which sets the size of differences.
MotionDerivative differentiate(const MotionLoad& load,
                               double time,
                               double arc_length,
                               const PointMotion& motion,
                               const NodeLinearization& linearization,
                               double length);

// Returns the motion of a node's point.
PointMotion find_point_motion(const NodeMotion& motion);
// Computes the derivative of the rotation vector of Λ by a spin δφ in front of it: log(exp(δφ) Λ).
Mat3 differentiate_rotation_vector(const Quat& Lambda);

// Computes forces and moments on an element's nodes, spatial, six per node: (S20) of docs/theory/springs.md.
LoadVector compute_motion_load(const LoadedElement& element,
                               double time,
                               const std::vector<NodeMotion>& motions);

// Computes their derivative by (δr, δφ) of the element's nodes. `length` as above.
LoadMatrix compute_motion_load_tangent(const LoadedElement& element,
                                       double time,
                                       const std::vector<NodeMotion>& motions,
                                       const std::vector<NodeLinearization>& linearizations,
                                       double length);

}  // namespace gxrod
