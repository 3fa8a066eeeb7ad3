#pragma once

#include <optional>

#include "analyses/static_work.hpp"
#include "assembly/system.hpp"
#include "integrators/integrator.hpp"
#include "solvers/equilibrium.hpp"
#include "state/energy_jump.hpp"
#include "state/records/restart_record.hpp"
#include "state/records/step_record.hpp"

namespace gxrod {

// The books at the end of a stage, for the next one.
struct LedgerTotals {
    double initial_energy = 0.0;
    double external_work = 0.0;
    double dissipated = 0.0;
    double dissipated_by_scheme = 0.0;
    double fluid_work = 0.0;
    double contact_loss = 0.0;
    double initial_contact_energy = 0.0;
    double kinetic_energy = 0.0;
    double largest_energy = 0.0;
};

// Keeps the books of a run: energies, work and momenta, and how far they fail to balance
// (docs/theory/energy.md).
class Ledger {
  public:
    // Empty books, for resume().
    Ledger(const System& system, const Integrator& integrator)
        : system_(&system), integrator_(&integrator), power_weights_(integrator.power_weights()) {}
    // `state` is the initial one and `residual` its own; whether its loads act there already, in statics. Of
    // a stage after another one, where they do: with the books at the end of that.
    Ledger(const System& system,
           const Integrator& integrator,
           const State& state,
           const Residual& residual,
           bool is_loaded,
           const LedgerTotals* before = nullptr);

    // A step from state.previous to state.trial, which ends at `time`; before it is committed. `residual` is
    // that of the trial, `stage_powers` what the step's stages recorded.
    struct Step {
        double time;
        double time_step;
        const Residual& residual;
        const std::vector<Power>& stage_powers;
    };
    void add_step(const State& state, const Step& step);

    // The state settles at an instant (solvers/steps/settling.hpp): with the last accepted motions as the
    // trial, and then with those of the equilibrium before they are committed. `residual` is that of either.
    // What loads and supports do on the way and the model does not store is dissipated.
    void begin_settling(const State& state, double time, const Residual& residual);
    void end_settling(const State& state, double time, const Residual& residual);

    // Whether the work of the last load step parts so far from the strain energy, before the step is
    // committed, that only equilibria in between show whether the structure jumped; and the ends of the
    // step, to look for these, and the work that they make of it.
    bool is_unclear() const;
    // Whether the last load step has released what a start that is not in equilibrium held back.
    bool has_released() const { return release_ > energy_worth_a_word * largest_energy_; }
    struct LoadStepEnds {
        const std::vector<Vec6>& forces_before;
        const std::vector<Vec6>& forces_after;
        double energy_before;
        double energy_after;
        double largest_energy;
    };
    LoadStepEnds load_step_ends() const {
        return {forces_before_,
                forces_,
                strain_energy_before_,
                strain_energy_ + law_dissipation_ + contact_change_,
                largest_energy_};
    }
    void replace_work(const StepWork& work);
    // Books what the work of the last load step exceeds the change of the strain energy by as dissipated: by
    // relaxation, which knows no path of equilibria. The next load step follows none either.
    void settle_load_step();

    // What turns the model with a frame does the work that the balance leaves, which is then its own.
    void add_drive() { has_drive_ = true; }

    LedgerRow row(const State& state) const;

    LedgerTotals totals(const State& state) const;
    LedgerMemory memory() const;
    void resume(const LedgerMemory& memory);

  private:
    // Schemes of several stages weigh the powers that these record.
    bool weighs_powers() const { return !power_weights_.empty(); }
    std::vector<Vec6> compute_forces(const State& state, double time, const Residual& residual) const;
    void add_load_step(const State& state, const Step& step, const std::vector<Vec6>& forces);
    void add_powers(const Step& step);
    void add_fluid_work(const State& state, double time);
    void add_contact_work(const State& state, double time);
    // In statics, after a step.
    void measure_largest_energy();
    double compute_scheme_dissipation(const State& state, double time_step) const;

    const System* system_;
    const Integrator* integrator_;
    std::vector<double> power_weights_;
    double initial_energy_ = 0.0;
    double initial_potential_ = 0.0;
    // At the last accepted step. The forces of one-stage schemes, the powers of others.
    std::vector<Vec6> forces_;
    Power power_;
    LoadStep load_step_;  // in statics, the last one, and what it came from
    std::vector<Vec6> forces_before_;
    std::optional<Balance> balance_;  // there; none before the first load step of a run
    double strain_energy_before_ = 0.0;
    double strain_energy_ = 0.0;
    double drive_work_ = 0.0;       // of what acts within sections, in the last step
    double law_dissipation_ = 0.0;  // of sections, in the last step
    double largest_energy_before_ = 0.0;
    double largest_energy_ = 0.0;  // in statics: strain energy or work
    StepWork step_work_;           // of the last load step
    std::vector<Vec6>
        held_;              // what would hold the start where it is, in statics; empty from the first step on
    double release_ = 0.0;  // how much work that could have done in the last step, if it vanished there
    double work_before_ = 0.0;  // of loads and moving supports, before that step
    double work_ = 0.0;
    double dissipated_ = 0.0;
    double dissipated_by_scheme_ = 0.0;
    double fluid_work_ = 0.0;
    double contact_loss_ = 0.0;
    double contact_energy_ = 0.0;  // at the last accepted step
    double contact_change_ = 0.0;  // in the last step: stored and lost, less what obstacles did
    double initial_contact_energy_ = 0.0;
    std::vector<Vec6> fluid_forces_;  // at the last accepted step; empty where nothing is around
    bool has_drive_ = false;
    // Where the state begins to settle.
    std::vector<Vec6> forces_before_settling_;
    double error_before_settling_ = 0.0;
};

}  // namespace gxrod
