#pragma once

#include <functional>

#include "solvers/equilibrium.hpp"

namespace gxrod {

// Called around a part of the way: with the last accepted motions as the trial, and with those of the
// equilibrium before they are committed. The workspace has the residual of either.
struct SettlingBooks {
    std::function<void()> begin;
    std::function<void()> end;
};

// Finds the equilibrium at an instant from a last accepted state that is out of balance there: what is out of
// balance is let go at once, or, where Newton's method fails on that, in parts, each an accepted state. Parts
// are equilibria with the rest of it as a dead force. `stage` is that of the integrator, InstantStep or that
// of statics; the state's time stays. If the report is not converged, the state is the last part's.
EquilibriumReport settle(const System& system,
                         const Integrator& integrator,
                         const NewtonSettings& settings,
                         const Stage& stage,
                         SolverWorkspace& workspace,
                         State& state,
                         const SettlingBooks& books);

}  // namespace gxrod
