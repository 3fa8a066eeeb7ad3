#pragma once

#include "assembly/system.hpp"
#include "integrators/integrator.hpp"
#include "results/restart_record.hpp"
#include "results/step_record.hpp"
#include "solvers/equilibrium.hpp"

namespace gxrod {

// Keeps the books of a run: energies, work and momenta, and how far they fail to balance.
class Ledger {
  public:
    // Empty books, for resume().
    Ledger(const System& system, const Integrator& integrator)
        : system_(&system), power_weights_(integrator.power_weights()) {}
    // `state` is the initial one and `residual` its own.
    Ledger(const System& system, const Integrator& integrator, const State& state, const Residual& residual);

    // A step from state.previous to state.trial, which ends at `time`; before it is committed. `residual` is
    // that of the trial, `stage_powers` what the step's stages recorded.
    struct Step {
        double time;
        double time_step;
        const Residual& residual;
        const std::vector<Power>& stage_powers;
    };
    void add_step(const State& state, const Step& step);

    LedgerRow row(const State& state) const;

    LedgerMemory memory() const;
    void resume(const LedgerMemory& memory);

  private:
    const System* system_;
    std::vector<double> power_weights_;
    double initial_energy_ = 0.0;
    double initial_potential_ = 0.0;
    WorkingForces forces_;  // at the last accepted step
    Power power_;
    double driving_work_ = 0.0;
    double dissipated_ = 0.0;
};

}  // namespace gxrod
