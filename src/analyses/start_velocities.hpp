#pragma once

#include "solvers/equilibrium.hpp"

namespace gxrod {

// Gives the trial motions the velocities nearest to theirs, measured by the mass matrix, that joints allow at
// `time`, the start of the step; or, unless that is asked for, throws EvaluationError if theirs are
// others. Models without joints are left alone.
void fit_start_velocities(const System& system,
                          double time,
                          const TimeSpan& step,
                          bool projects,
                          SolverWorkspace& workspace,
                          State& state);

}  // namespace gxrod
