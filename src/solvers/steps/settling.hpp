#pragma once

#include <functional>

#include "solvers/equilibrium.hpp"

namespace gxrod {

// Functions that are called before and after a part of settling: with the last accepted motions as the trial,
// and with the equilibrium's before they are committed. The workspace has the residual of the trial.
struct SettlingBooks {
    std::function<void()> begin;
    std::function<void()> end;
};

// Finds the equilibrium at an instant from a last accepted state that is out of balance there. The unbalanced
// force is released at once, or, if Newton's method then fails, in parts, each of which is an accepted state:
// an equilibrium with the rest as a dead force. `stage` belongs to the integrator: InstantStep or the one of
// statics; the state's time stays. If the report is not converged, the state is the last part.
EquilibriumReport settle(const SolverSetup& setup,
                         const Stage& stage,
                         SolverWorkspace& workspace,
                         State& state,
                         const SettlingBooks& books);

}  // namespace gxrod
