#pragma once

#include "solvers/equilibrium.hpp"

// Conditions of joints at the end of a step in addition to its equilibrium (docs/theory/joints.md, Solution).
namespace gxrod {

// Returns whether velocities and accelerations have to meet separate equations.
bool has_hidden_constraints(const System& system);

// Finds the time in which the fastest node moves by the model's length or turns by a radian; 1 if all rest.
// It converts rows of velocities to lengths and angles.
double find_time_scale(const System& system, const State& state);

// Changes the trial velocities by as little as possible, measured by the matrix last factorized, so that they
// meet Gv + Φ_t = 0. Reports it if they do not. Returns the sum of the solutions, whose velocities are
// multiplied by find_time_scale.
Eigen::VectorXd project_velocities(const System& system,
                                   double time,
                                   const TimeSpan& step,
                                   SolverWorkspace& workspace,
                                   State& state,
                                   EquilibriumReport& report);

// Changes the trial positions likewise, so that they meet Φ = 0.
Eigen::VectorXd project_positions(
    const System& system, double time, SolverWorkspace& workspace, State& state, EquilibriumReport& report);

}  // namespace gxrod
