#pragma once

#include <vector>

#include "solvers/equilibrium.hpp"

// Rates at the end of a step corrected so that its energy and momenta balance (docs/theory/newmark.md,
// (M1) to (M3)).
namespace gxrod {

// What is compared with the end of a step.
struct StepStart {
    double energy = 0.0;  // kinetic and strain energy, and the potential of gravity
    Momentum momentum;
    Resultant acting;          // of all that acts from outside
    std::vector<Vec6> forces;  // that do work, of each node
};

// Of the trial motions, which are the last accepted ones; before the step.
StepStart note_step_start(const System& system, const State& state, double time);

// Adds the rigid motion to the trial's rates that gives the momenta of the start and the impulse of the step,
// and scales the rates relative to that motion so that the energy is that of the start and the work. Reports
// energy_out_of_reach, and leaves the rates, if that takes a factor that is not between ½ and 2.
void conserve(
    const System& system, const StepStart& start, const Stage& step, State& state, EquilibriumReport& report);

}  // namespace gxrod
