#pragma once

#include <memory>

#include "analyses/ledger.hpp"
#include "assembly/system.hpp"
#include "integrators/integrator.hpp"
#include "results/step_record.hpp"
#include "solvers/equilibrium.hpp"
#include "solvers/step_control.hpp"

namespace gxrod {

// Motion in time from given initial conditions: step by step, halving a step that fails.
class DynamicAnalysis {
  public:
    // The model must outlive the analysis.
    DynamicAnalysis(const Model& model, const DynamicSettings& settings);

    // Solves for the initial accelerations; before anything else.
    EquilibriumReport start();
    // One accepted step, of the nominal length or a part of it. If even the shortest step fails, the report
    // says why and the state is the last accepted one.
    EquilibriumReport advance();
    bool finished() const { return control_.finished(); }

    const System& system() const { return system_; }
    const State& state() const { return state_; }
    const StepControl& control() const { return control_; }
    const PhaseSeconds& seconds() const { return workspace_.seconds; }

    LedgerRow ledger_row() const { return ledger_->row(state_); }
    const SolverRow& solver_row() const { return solver_row_; }
    // Of the last accepted state; valid until the next step.
    Snapshot snapshot();

  private:
    // Tries the next step; if that fails, or a load throws EvaluationError, the state is as before.
    bool take_step(EquilibriumReport& report);

    System system_;
    DynamicSettings settings_;
    std::unique_ptr<Integrator> integrator_;
    SolverWorkspace workspace_;
    StepControl control_;
    State state_;
    std::unique_ptr<Ledger> ledger_;
    SolverRow solver_row_;
    Residual residual_;
    std::vector<SectionValues> section_values_;
};

}  // namespace gxrod
