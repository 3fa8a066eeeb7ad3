#include "constraints/joints/joint_motors.hpp"

namespace gxrod {

PrescribedCoordinate compute_motor(const std::optional<TimeFunction>& motion,
                                   double time,
                                   const TimeSpan& step,
                                   ConstraintLevel level) {
    PrescribedCoordinate prescribed;
    if (!motion) return prescribed;
    prescribed.value = (*motion)(time);
    if (level == ConstraintLevel::position || motion->is_constant()) return prescribed;
    const StepDifferences differences = compute_step_differences(time, step);
    for (int k = 0; k < difference_points; ++k) {
        const double value = (*motion)(differences.times[k]);
        prescribed.rate += differences.first[k] * value;
        prescribed.acceleration += differences.second[k] * value;
    }
    return prescribed;
}

double differentiate(const TimeFunction& function, double time, const TimeSpan& step) {
    if (function.is_constant() || step.length == 0.0) return 0.0;
    const StepDifferences differences = compute_step_differences(time, step);
    double rate = 0.0;
    for (int k = 0; k < difference_points; ++k) rate += differences.first[k] * function(differences.times[k]);
    return rate;
}

JointMotors compute_motors(const Joint& joint, double time, const TimeSpan& step, ConstraintLevel level) {
    return {compute_motor(joint.turn.motion, time, step, level),
            compute_motor(joint.slide.motion, time, step, level)};
}

}  // namespace gxrod
