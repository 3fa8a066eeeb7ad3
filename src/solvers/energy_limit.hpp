#pragma once

#include "solvers/equilibrium.hpp"

namespace gxrod {

// Takes a surplus of energy from the velocities of a step that is solved and not committed
// (docs/theory/contact.md, (C25)): first from vibrations, by an impulse of a damper proportional to the
// stiffness, which leaves the momenta of free parts and meets supports and joints; what these do not have,
// from all that moves. Returns the kinetic energy taken, at least the surplus; or 0, with the velocities as
// they were, if that is more than what moves can give.
double take_surplus(
    const System& system, const Stage& step, double surplus, SolverWorkspace& workspace, State& state);

}  // namespace gxrod
