#pragma once

#include "assembly/system.hpp"
#include "integrators/integrator.hpp"
#include "results/step_record.hpp"

namespace gxrod {

// Keeps the books of a run: energies, work and momenta, and how far they fail to balance.
class Ledger {
  public:
    // `state` is the initial one.
    Ledger(const System& system, const Integrator& integrator, const State& state);

    // Adds the work of the loads over the step from state.previous to state.trial, which ends at `time`;
    // before the step is committed. load_power is what the step's stages recorded.
    void add_work(const State& state, double time, const std::vector<double>& load_power, double time_step);

    LedgerRow row(const State& state) const;

  private:
    const System* system_;
    std::vector<double> power_weights_;
    double initial_energy_;
    double initial_potential_;
    double load_work_ = 0.0;
};

}  // namespace gxrod
