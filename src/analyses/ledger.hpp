#pragma once

#include <optional>

#include "analyses/static_work.hpp"
#include "assembly/system.hpp"
#include "assembly/system_measures.hpp"
#include "integrators/integrator.hpp"
#include "solvers/equilibrium.hpp"
#include "state/energy_jump.hpp"
#include "state/records/restart_record.hpp"
#include "state/records/step_record.hpp"

namespace gxrod {

// The totals at the end of a stage, for the next stage.
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

// Keeps the books of a run: energies, work, momenta and their errors of balance (docs/theory/energy.md).
class Ledger {
  public:
    // Makes an empty ledger, for resume().
    Ledger(const System& system, const Integrator& integrator)
        : system_(&system), integrator_(&integrator), power_weights_(integrator.power_weights()) {}
    // Starts the books with the initial state and its residual. `is_loaded`: in statics, whether the loads
    // act there already. For a stage that follows another one, `before` has the totals at the end of that
    // stage.
    Ledger(const System& system,
           const Integrator& integrator,
           const State& state,
           const Residual& residual,
           bool is_loaded,
           const LedgerTotals* before = nullptr);

    // A step from state.previous to state.trial, which ends at `time`, before it is committed. `residual`
    // belongs to the trial; the stages of the step recorded `stage_powers`.
    struct Step {
        double time;
        double time_step;
        const Residual& residual;
        const std::vector<Power>& stage_powers;
    };
    void add_step(const State& state, const Step& step);
    // Returns how much of the energy after the step that was just added nothing explains, beyond what is
    // tolerated; 0 in analyses that do not limit it.
    double surplus() const;
    // Returns whether something touches at the end of the step.
    bool touches() const { return contact_energy_ != 0.0; }
    // Whether steps must not gain energy: of motions with contact.
    bool limits_energy() const;

    // Book that the state settles at an instant (solvers/steps/settling.hpp). The first is called with the
    // last accepted motions as the trial, the second with the motions of the equilibrium before they are
    // committed, each with the residual of its trial. Work of loads and supports on the way that the model
    // does not store is dissipated.
    void begin_settling(const State& state, double time, const Residual& residual);
    void end_settling(const State& state, double time, const Residual& residual);

    // Whether the work of the last load step differs so much from the change of the strain energy, before the
    // step is committed, that only equilibria in between show whether the structure jumped. Then
    // load_step_ends() gives the ends of the step for that search, and replace_work() takes its result.
    bool is_unclear() const;
    // Whether the last load step has released stresses of a start that was not in equilibrium.
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
    // Books work of the last load step beyond the change of the strain energy as dissipated: relaxation
    // follows no path of equilibria. The next load step does not extrapolate from this one either.
    void settle_load_step();

    // Declares that a drive turns the model with a frame; the rest of the balance is the work of that drive.
    void add_drive() { has_drive_ = true; }

    LedgerRow row(const State& state) const;

    LedgerTotals totals(const State& state) const;
    LedgerMemory memory() const;
    void resume(const LedgerMemory& memory);

  private:
    // Adds a step of whose energy nothing is lost at once.
    void add_any_step(const State& state, const Step& step);
    // Whether the scheme has several stages; it then weighs the powers that they record.
    bool weighs_powers() const { return !power_weights_.empty(); }
    std::vector<Vec6> compute_forces(const State& state, double time, const Residual& residual) const;
    void add_load_step(const State& state, const Step& step, const std::vector<Vec6>& forces);
    void add_powers(const Step& step);
    void add_contact_powers(const Step& step);
    void add_fluid_work(const State& state, double time);
    void add_contact_work(const State& state, double time);
    // Updates the largest energy after a step, in statics.
    void measure_largest_energy();
    // Books what a step has lost, where steps must not gain energy. `touches`: whether anything touched in
    // it.
    void book_loss(const State& state, double time, bool touches);
    double compute_scheme_dissipation(const State& state, double time_step) const;

    const System* system_;
    const Integrator* integrator_;
    std::vector<double> power_weights_;
    double initial_energy_ = 0.0;
    double initial_potential_ = 0.0;
    // Values at the last accepted step: forces for one-stage schemes, powers for others.
    std::vector<Vec6> forces_;
    Power power_;
    LoadStep load_step_;  // in statics, the last load step, and the forces at its start
    std::vector<Vec6> forces_before_;
    std::optional<Balance> balance_;  // at the last accepted step; none before the first load step of a run
    double strain_energy_before_ = 0.0;
    double strain_energy_ = 0.0;
    double drive_work_ = 0.0;       // work of actions within sections, in the last step
    double law_dissipation_ = 0.0;  // dissipation of sections, in the last step
    double largest_energy_before_ = 0.0;
    // Strain energy or work in statics; all energy where it is limited, negative until something touches.
    double largest_energy_ = 0.0;
    double energy_error_ = 0.0;  // after the last step, where energy is limited
    StepWork step_work_;         // work of the last load step
    std::vector<Vec6>
        held_;  // forces that would hold the start in place, in statics; empty from the first step on
    double release_ = 0.0;      // the work of these forces in the last step, if they vanish there
    double work_before_ = 0.0;  // work of loads and moving supports before that step
    double work_ = 0.0;
    double dissipated_ = 0.0;
    double dissipated_by_scheme_ = 0.0;
    double fluid_work_ = 0.0;
    double contact_loss_ = 0.0;
    double contact_energy_ = 0.0;  // at the last accepted step
    double contact_change_ = 0.0;  // in the last step: stored and lost, less what obstacles did
    double initial_contact_energy_ = 0.0;
    std::vector<Vec6> fluid_forces_;  // at the last accepted step; empty without surroundings
    bool has_drive_ = false;
    // Values at which the state begins to settle.
    std::vector<Vec6> forces_before_settling_;
    double error_before_settling_ = 0.0;
};

}  // namespace gxrod
