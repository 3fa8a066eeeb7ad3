#include "analyses/static_work.hpp"

#include <algorithm>
#include <cmath>

namespace gxrod {

std::vector<Vec6> compute_movement(const State& state) {
    std::vector<Vec6> movement(state.trial.size());
    for (std::size_t i = 0; i < movement.size(); ++i) {
        movement[i] << state.trial[i].r - state.previous[i].r, state.trial[i].theta;
    }
    return movement;
}

StepWork compute_step_work(const std::vector<Vec6>& forces_at_start,
                           const LoadStep& step,
                           const LoadStep& before) {
    double trapezoid = 0.0;
    double half_width = 0.0;  // of the interval between the work of either end's forces
    double of_both = 0.0;     // the rule over both steps less its sum over each
    for (std::size_t i = 0; i < forces_at_start.size(); ++i) {
        const Vec6& dF = step.force_change[i];
        const Vec6& dr = step.movement[i];
        trapezoid += (forces_at_start[i] + 0.5 * dF).dot(dr);
        half_width += 0.5 * std::abs(dF.dot(dr));
        if (before.length == 0.0) continue;
        of_both += 0.5 * (dF.dot(before.movement[i]) - before.force_change[i].dot(dr));
    }
    if (before.length == 0.0) return {trapezoid, half_width};
    // Of a rule whose error grows with the cube of the step.
    const double h = step.length;
    const double g = before.length;
    const double error = of_both * h * h / (3.0 * g * (g + h));
    const double correction = std::clamp(error, -half_width, half_width);
    return {trapezoid - correction, half_width + 2.0 * std::abs(error)};
}

}  // namespace gxrod
