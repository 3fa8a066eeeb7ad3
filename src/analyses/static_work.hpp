#pragma once

#include "state/state.hpp"

namespace gxrod {

// What loads and moving supports did from one equilibrium to the next, and how far that may be off.
struct StepWork {
    double work = 0.0;
    double uncertainty = 0.0;
};

// How forces (and moments) per node changed in a load step, and how far they moved (and turned) their nodes.
struct LoadStep {
    std::vector<Vec6> force_change;
    std::vector<Vec6> movement;
    double length = 0.0;  // of the load factor; 0 of none
};

std::vector<Vec6> compute_movement(const State& state);

// The work of a load step, between whose ends no equilibrium is known. `before` is the load step that led to
// it. Where forces and movements only grow, or only fall, within the step, the work lies between that of the
// forces at its start and at its end; the trapezoidal rule is the middle. It is corrected by what the rule
// over both steps at once says of it (Richardson), which a smooth path satisfies also where it turns back.
StepWork compute_step_work(const std::vector<Vec6>& forces_at_start,
                           const LoadStep& step,
                           const LoadStep& before);

}  // namespace gxrod
