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

// Solves with the factorized tangent for minus `residual` into workspace.vector; false if that is not finite.
bool solve_increment(const System& system,
                     const Eigen::VectorXd& residual,
                     SolverWorkspace& workspace,
                     EquilibriumReport& report);

}  // namespace gxrod
