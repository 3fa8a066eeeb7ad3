#pragma once

#include "solvers/equilibrium.hpp"

namespace gxrod {

// Gives the trial motions the velocities nearest to theirs, measured by the mass matrix, that joints allow at
// `time`, the start of the step; or, unless that is asked for, throws EvaluationError if theirs are
// others by more than the differences by which rates of moves are taken. Models without joints are left
// alone.
void fit_start_velocities(const System& system,
                          double time,
                          const TimeSpan& step,
                          bool projects,
                          SolverWorkspace& workspace,
                          State& state);

// How far the rates that motors and moved supports prescribe jump, relative to the largest velocity, from the
// end of a stage, at the state's time, to the start of another one with the same nodes and joints. `step` is
// that one's first. A stage without time prescribes none: then all counts that the velocities do not fit.
double measure_rate_jump(
    const System& before, const State& at_end, const System& after, const State& at_start, double step);

}  // namespace gxrod
