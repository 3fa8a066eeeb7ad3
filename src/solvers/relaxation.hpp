#pragma once

#include "solvers/equilibrium.hpp"

namespace gxrod {

struct RelaxationReport {
    EquilibriumReport equilibrium;  // report of Newton's method at the end; iterations of all pseudo-steps
    int pseudo_steps = 0;
};

// Lets a model fall in pseudo-time from the last accepted motions to a stable equilibrium under the loads at
// the end of the stage, in statics without contact, and ends with Newton's method there. Pseudo-steps grow as
// they succeed, and stay so short that the energy is convex about each, so they cannot end at an unstable
// equilibrium. The trial motions hold the result; sections, joints and the ground keep their memory of the
// last accepted step, as in any other load step.
RelaxationReport relax(const System& system,
                       const Integrator& integrator,
                       const NewtonSettings& settings,
                       const Stage& stage,
                       SolverWorkspace& workspace,
                       State& state);

}  // namespace gxrod
