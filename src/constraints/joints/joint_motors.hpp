#pragma once

#include "constraints/joints/joint_rows.hpp"
#include "constraints/step_differences.hpp"

namespace gxrod {

// Compute the motions that motors prescribe at `time`, 0 without a motor; derivatives, by differences within
// the step, only for levels that need them.
PrescribedCoordinate compute_motor(const std::optional<TimeFunction>& motion,
                                   double time,
                                   const TimeSpan& step,
                                   ConstraintLevel level);
JointMotors compute_motors(const Joint& joint, double time, const TimeSpan& step, ConstraintLevel level);

// Computes the derivative of a function at `time`, by differences within the step; 0 if the step has no
// length.
double differentiate(const TimeFunction& function, double time, const TimeSpan& step);

}  // namespace gxrod
