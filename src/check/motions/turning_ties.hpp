#pragma once

#include <string>

#include "model/model.hpp"
#include "model/settings/turning_frame.hpp"

namespace gxrod {

// Returns the reason why a spring, a bushing or a joint is not steady in a frame that turns, a sentence: it
// is tied to the ground, and is not alike to all sides of the axis of rotation. "" if all are.
std::string find_unsteady_tie(const Model& model, const TurningFrame& frame);

// Whether what acts on a joint's turn depends on the angle, or on more of its rate than a damping does.
bool depends_on_turn(const JointCoordinate& turn);
// Whether two vectors have one direction or opposite ones.
bool are_parallel(const Vec3& one, const Vec3& other);
// Whether a matrix of forces and moments by displacements and rotations commutes with turns about an axis,
// both in the same axes.
bool is_alike_about(const Vec3& axis, const Mat6& matrix);

}  // namespace gxrod
