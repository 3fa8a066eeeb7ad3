#pragma once

#include <optional>

#include "analyses/ledger.hpp"
#include "solvers/conservation.hpp"
#include "solvers/equilibrium.hpp"

// Looks after the energy of a step that is solved and not yet accepted.
namespace gxrod {

struct TriedStep {
    const System& system;
    const Integrator& integrator;
    const Ledger& ledger;  // before the step
    Stage stage;           // the whole step
    SolverWorkspace& workspace;
    State& state;

    Ledger::Step books() const {
        return {stage.end_time, stage.time_step, workspace.residual, workspace.stage_powers};
    }
};

// Corrects the rates so that the ledger and the momenta balance (docs/theory/newmark.md, (M1) to (M3)), again
// where work depends on the rates. Returns the ledger after the step if it is known by then.
std::optional<Ledger> conserve_energy(const TriedStep& step,
                                      const StepStart& start,
                                      EquilibriumReport& report);

// Takes energy that nothing explains from the rates, or fails the report, where steps must not gain any
// (docs/theory/contact.md, (C25)). `cuts`: how often the step has been cut; stages resolve an impact in
// shorter steps, so at first those are. Returns the ledger after a step that has gained nothing.
std::optional<Ledger> limit_energy(const TriedStep& step, int cuts, EquilibriumReport& report);

}  // namespace gxrod
