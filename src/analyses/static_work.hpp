#pragma once

#include "state/state.hpp"

namespace gxrod {

// The work of loads and moving supports from one equilibrium to the next, with its uncertainty.
struct StepWork {
    double work = 0.0;
    double uncertainty = 0.0;
};

// The changes of forces (and moments) per node in a load step, and the displacements (and rotations) of the
// nodes.
struct LoadStep {
    std::vector<Vec6> force_change;
    std::vector<Vec6> movement;
    double length = 0.0;  // change of the load factor; 0 if there is no step
};

std::vector<Vec6> compute_movement(const State& state);

// Computes the work of a load step from its two ends only. `before` is the previous load step. If forces and
// movements grow or fall monotonically within the step, the work lies between the work of the forces at its
// start and of the forces at its end; the trapezoidal rule is the middle. Comparison with the rule over both
// steps at once corrects it (Richardson extrapolation), which holds on a smooth path even where it turns
// back.
StepWork compute_step_work(const std::vector<Vec6>& forces_at_start,
                           const LoadStep& step,
                           const LoadStep& before);

}  // namespace gxrod
