#pragma once

#include "constraints/joints/joint_rows.hpp"
#include "constraints/step_differences.hpp"

namespace gxrod {

// What a joint's motors prescribe at `time`; derivatives, by differences within the step, only for levels
// that need them.
JointMotors compute_motors(const Joint& joint, double time, const TimeSpan& step, ConstraintLevel level);

// The derivative of a function at `time`, by differences within the step; 0 if that has no length.
double differentiate(const TimeFunction& function, double time, const TimeSpan& step);

}  // namespace gxrod
