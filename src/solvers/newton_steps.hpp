#pragma once

#include "solvers/equilibrium.hpp"

// What Newton's method and the solution for accelerations are made of.
namespace gxrod {

// The residual's size relative to its scales, and where it is largest.
void measure_residual(const System& system, const Residual& residual, EquilibriumReport& report);

// Whether a residual so measured is a tenth of the largest force that acts in the group of its worst node, or
// of the largest moment over the length of its part.
bool is_as_large_as_forces(const System& system, const Residual& residual, const EquilibriumReport& report);

// The residual as the right-hand side of the linear system whose matrix has these values.
Eigen::VectorXd gather_residual(const System& system,
                                const Residual& residual,
                                const std::vector<double>& values);

double largest_component(const System& system, const Residual& residual);

// Factorizes workspace.values; false, and so reported, if they are singular.
bool factorize(const System& system, SolverWorkspace& workspace, EquilibriumReport& report);

// The equations of joints that a stage asks for. Those that are linear in positions hold at all levels if
// they do at one: at that of positions errors of rounding do not grow. The factor is left at 1.
ConstraintRequest find_request(const System& system, const Integrator& integrator, const Stage& stage);

// Adds the solution in workspace.vector to the trial accelerations, and moves their multipliers with it.
void add_accelerations(const System& system, SolverWorkspace& workspace, State& state);
// How often accelerations are corrected for what the regularization of JointAssembly leaves of the equations
// of joints, and for friction that follows their multipliers.
int count_corrections(const System& system);

// Solves with the factorized tangent for minus `residual` into workspace.vector; false if that is not finite.
bool solve_increment(const System& system,
                     const Eigen::VectorXd& residual,
                     SolverWorkspace& workspace,
                     EquilibriumReport& report);

}  // namespace gxrod
