#pragma once

#include "solvers/equilibrium.hpp"

namespace gxrod {

// Gives the trial motions the velocities nearest to their own, measured by the mass matrix, that joints allow
// at `time`, the start of the step. If projection is not asked for, throws EvaluationError if the two differ
// by more than the error of differentiating prescribed moves. Models without joints are left alone.
void fit_start_velocities(const System& system,
                          double time,
                          const TimeSpan& step,
                          bool projects,
                          SolverWorkspace& workspace,
                          State& state);

// Measures the jump of the rates that motors and moved supports prescribe, relative to the largest velocity,
// from the end of one stage, at the state's time, to the start of another stage with the same nodes and
// joints. `step` is the first step of the second stage. A stage without time prescribes no rates: then every
// velocity that does not fit counts.
double measure_rate_jump(
    const System& before, const State& at_end, const System& after, const State& at_start, double step);

}  // namespace gxrod
