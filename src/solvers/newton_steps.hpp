#pragma once

#include "solvers/equilibrium.hpp"

// What Newton's method and the solution for accelerations are made of.
namespace gxrod {

// What a residual's forces and moments are small against. A force at the model's length is a moment: neither
// scale falls to round-off of the other.
struct ResidualScales {
    double force, moment;
    double of(int component) const { return component < 3 ? force : moment; }
};
ResidualScales compute_scales(const System& system, const Residual& residual);

// The residual's size relative to its scales, and where it is largest.
void measure_residual(const System& system, const Residual& residual, EquilibriumReport& report);

// Whether a residual so measured is a tenth of the largest force there is, or of the largest moment over the
// model's length.
bool is_as_large_as_forces(const System& system, const Residual& residual, const EquilibriumReport& report);

double largest_component(const System& system, const Residual& residual);

// Factorizes workspace.values; false, and so reported, if they are singular.
bool factorize(const System& system, SolverWorkspace& workspace, EquilibriumReport& report);

// Solves with the factorized tangent for minus `residual` into workspace.vector; false if that is not finite.
bool solve_increment(const System& system,
                     const Eigen::VectorXd& residual,
                     SolverWorkspace& workspace,
                     EquilibriumReport& report);

}  // namespace gxrod
