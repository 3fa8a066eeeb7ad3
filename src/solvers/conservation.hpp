#pragma once

#include <vector>

#include "assembly/system_measures.hpp"
#include "solvers/equilibrium.hpp"

// Corrects the rates at the end of a step so that its energy and momenta balance (docs/theory/newmark.md,
// (M1) to (M3)).
namespace gxrod {

// Quantities at the start of a step that are compared with its end.
struct StepStart {
    Momentum momentum;
    Resultant acting;           // resultant of all external forces
    double energy_error = 0.0;  // of the ledger
};

// Notes momenta and forces before the step, from the trial motions, which are then the last accepted ones.
StepStart note_step_start(const System& system, const State& state, double time);

// Adds a rigid motion to the trial's rates so that the momenta are the start's plus the impulse of the step;
// none where supports or joints to the ground hold the model. Then scales the rates relative to that motion
// so that the kinetic energy is less by `surplus`. Reports energy_out_of_reach, and leaves the rates, if the
// factor is not between ½ and 2.
void conserve(const System& system,
              const StepStart& start,
              const Stage& step,
              double surplus,
              State& state,
              EquilibriumReport& report);

}  // namespace gxrod
