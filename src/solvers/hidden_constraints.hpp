#pragma once

#include "solvers/equilibrium.hpp"

// What joints ask of the end of a step in addition to its equilibrium (docs/theory/joints.md, Solution).
namespace gxrod {

// Whether velocities and accelerations have to meet equations of their own.
bool has_hidden_constraints(const System& system);

// The time in which the fastest node moves by the model's length or turns by a radian; 1 if all rest. It
// turns rows of velocities into lengths and angles.
double find_time_scale(const System& system, const State& state);

// Changes the trial velocities by as little as possible, measured by the matrix last factorized, so that they
// meet Gv + Φ_t = 0. Reported if they do not. If `total` is given, it is set to the sum of the solutions,
// whose velocities are multiplied by find_time_scale.
void project_velocities(const System& system,
                        double time,
                        const TimeSpan& step,
                        SolverWorkspace& workspace,
                        State& state,
                        EquilibriumReport& report,
                        Eigen::VectorXd* total = nullptr);

// The same of positions and Φ = 0.
void project_positions(const System& system,
                       double time,
                       SolverWorkspace& workspace,
                       State& state,
                       EquilibriumReport& report,
                       Eigen::VectorXd* total = nullptr);

}  // namespace gxrod
