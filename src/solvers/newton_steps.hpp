#pragma once

#include "solvers/equilibrium.hpp"

// Steps of Newton's method and of the solution for accelerations.
namespace gxrod {

// Measures the residual relative to its scales, and finds where it is largest.
void measure_residual(const System& system, const Residual& residual, EquilibriumReport& report);

// Returns whether a residual so measured is a tenth of the largest force that acts in the group of its worst
// node, or of the largest moment over the length of its part.
bool is_as_large_as_forces(const System& system, const Residual& residual, const EquilibriumReport& report);

// Returns the residual as the right-hand side of the linear system whose matrix has these values.
Eigen::VectorXd gather_residual(const System& system,
                                const Residual& residual,
                                const std::vector<double>& values);

double largest_component(const System& system, const Residual& residual);

// Factorizes workspace.values. Returns false, and reports it, if they are singular.
bool factorize(const System& system, SolverWorkspace& workspace, EquilibriumReport& report);

// Finds the level at which a stage meets the equations of joints. Equations that are linear in positions hold
// at all levels if they do at one; they are met by positions, where errors of rounding do not grow. The
// factor is left at 1.
ConstraintRequest find_request(const System& system, const Integrator& integrator, const Stage& stage);

// Adds the solution in workspace.vector to the trial accelerations, and moves their multipliers with it.
void add_accelerations(const System& system, SolverWorkspace& workspace, State& state);
// Number of corrections of accelerations for the error that the regularization of JointAssembly leaves in the
// equations of joints, and for friction that follows their multipliers.
int count_corrections(const System& system);

// Solves with the factorized tangent for minus `residual` into workspace.vector; false if that is not finite.
bool solve_increment(const System& system,
                     const Eigen::VectorXd& residual,
                     SolverWorkspace& workspace,
                     EquilibriumReport& report);

}  // namespace gxrod
