#pragma once

#include "solvers/equilibrium.hpp"

// What joints ask of the end of a step in addition to its equilibrium (docs/theory/joints.md, Solution).
namespace gxrod {

// Changes the trial velocities by as little as possible, measured by the matrix last factorized, so that they
// meet Gv + Φ_t = 0. Reported if they do not.
void project_velocities(const System& system,
                        double time,
                        const TimeSpan& step,
                        SolverWorkspace& workspace,
                        State& state,
                        EquilibriumReport& report);

// The same of positions and Φ = 0.
void project_positions(
    const System& system, double time, SolverWorkspace& workspace, State& state, EquilibriumReport& report);

}  // namespace gxrod
