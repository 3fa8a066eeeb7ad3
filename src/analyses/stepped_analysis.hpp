#pragma once

#include <functional>
#include <memory>

#include "analyses/cut_tally.hpp"
#include "analyses/ledger.hpp"
#include "analyses/path_work.hpp"
#include "analyses/step_energy.hpp"
#include "analyses/step_follower.hpp"
#include "analyses/step_interior.hpp"
#include "assembly/system.hpp"
#include "assembly/system_measures.hpp"
#include "check/failure_advice.hpp"
#include "integrators/integrator.hpp"
#include "solvers/equilibrium.hpp"
#include "solvers/steps/step_sequence.hpp"
#include "state/records/step_record.hpp"

namespace gxrod {

// The base of all analyses in steps: takes one step after another and repeats a failed step with a shorter
// one.
class SteppedAnalysis {
  public:
    virtual ~SteppedAnalysis() = default;

    // Prepares the first step; before anything else.
    virtual EquilibriumReport start() = 0;
    // Starts from the state in which an earlier stage left the same mesh. Throws std::runtime_error if a
    // support that moves would have to jump there.
    EquilibriumReport start_after(const SteppedAnalysis& before);
    // In statics, replaces the start and all steps: finds the equilibrium under the loads at this time by
    // Newton's method from the state of an analysis of the same mesh. The books begin there.
    EquilibriumReport settle_after(const SteppedAnalysis& before, double time);
    // Returns a clause about that start that users should know: a motion that does not begin in equilibrium;
    // "" if there is none.
    const std::string& start_note() const { return start_note_; }
    // Takes one accepted step, if the sequence of steps has another one. If even the shortest step fails, the
    // report says why and the state is the last accepted one.
    EquilibriumReport advance();
    bool finished() const { return steps_->finished(); }
    // Makes a step end at this time, as StepSequence::land_on.
    std::optional<double> land_on(double time);

    // Records the last accepted step, to resume from later; the caller adds totals.
    RestartRecord restart_record() const;
    // Resumes from a record, in place of start(). Returns false if no step of this analysis can begin at that
    // time. Throws std::invalid_argument if the record belongs to another model.
    bool resume(const RestartRecord& record);

    // Explains why the start or the last step failed, where, and what to try. `report` must be the last one.
    Failure explain(const EquilibriumReport& report);

    const System& system() const { return system_; }
    // Returns the contribution of a frame to the matrices about the state, if the model turns with one.
    const FrameColumns* frame() const { return workspace_.frame; }
    const State& state() const { return state_; }
    const StepSequence& steps() const { return *steps_; }
    const PhaseSeconds& seconds() const { return workspace_.seconds; }

    // Warnings about the steps so far, a sentence each.
    virtual std::vector<std::string> list_warnings() const { return {}; }
    // Findings of the steps so far that call for no change of the deck, a sentence each.
    virtual std::vector<std::string> list_findings() const { return {}; }
    // Whether unstable equilibria were accepted.
    virtual bool is_unstable() const { return false; }

    LedgerRow ledger_row() const { return ledger_->row(state_); }
    const SolverRow& solver_row() const { return solver_row_; }
    // The cuts of the steps since the start, or since the run was resumed.
    const CutTally& cuts() const { return cuts_; }
    // The largest estimated error of the trials, 0 if the scheme estimates none; and the settings of Newton's
    // method.
    double largest_error() const { return largest_error_; }
    const NewtonSettings& newton() const { return newton_; }
    // Sets the points of rods, and the contacts of rods, that snapshots record; before the start.
    void watch(std::vector<RodPlace> places, std::vector<ContactWatch> contacts = {}) {
        watched_ = std::move(places);
        watched_contacts_ = std::move(contacts);
    }
    // The time axis of snapshots: the time of the loads, or another axis that grows from step to step.
    virtual double axis_time() const { return state_.time; }
    // Returns the snapshot of the last accepted state; valid until the next step. Sections of all elements
    // are included only if asked for.
    Snapshot snapshot(bool with_elements = true);
    // Sets what acts by the ends of the steps that are to come, and must outlive them; nullptr: nothing.
    void follow(StepFollower* follower) { follower_ = follower; }
    // Keeps the steps for whose ends this holds, so that they can be looked into.
    void keep_steps(std::function<bool(double from, double to)> is_wanted) {
        is_wanted_ = std::move(is_wanted);
    }
    // Returns the snapshot at a time within the last accepted step, which must have been kept; valid until
    // the next call or step.
    Snapshot snapshot_within(double time, bool with_elements = true) {
        return interior_->snapshot(time, with_elements, watched_, watched_contacts_);
    }
    // The state that the start or the last step settled in before anything else; nullptr if it did not.
    const State* settled() const { return settled_ ? &*settled_ : nullptr; }
    // The last accepted step as the scheme took it.
    const Stage& last_stage() const { return last_stage_; }
    const Stage& settled_stage() const { return settled_stage_; }
    // The number of parts in which it settled, each from the state that the part before left.
    int settled_parts() const { return settled_parts_; }
    // The stage and the integrator that settle the state.
    virtual Stage settling_stage() const { return {0, steps_->time(), 0.0, steps_->time()}; }
    virtual const Integrator& settling_integrator() const { return *integrator_; }
    // The start time of the last accepted step.
    double step_start() const { return step_start_; }
    // Returns the resultant of external actions on the last accepted state; in dynamics it is the rate of the
    // momenta.
    Resultant outer_resultant() const {
        return SystemMeasures(system_).compute_outer_resultant(state_, state_.time, reactions_);
    }

  protected:
    // The model must outlive the analysis. The threads share its work.
    SteppedAnalysis(const Model& model,
                    int threads,
                    std::unique_ptr<Integrator> integrator,
                    const NewtonSettings& newton,
                    LinearSolverKind linear_solver,
                    std::unique_ptr<StepSequence> steps);

    // Accepts the trial motions as the state at the start, at t = 0 or this time of the loads; the workspace
    // has their residual. Loads that already act there have done no work yet.
    void accept_start(double time = 0.0, bool is_loaded = false);
    // Starts likewise at t = 0, without velocities and accelerations.
    EquilibriumReport start_at_rest();
    // Throws std::runtime_error if rods penetrate obstacles, other rods or bodies; before any force is asked
    // for.
    void refuse_overlaps(double time);
    // The first stage of the next step.
    Stage next_stage() const;
    // Finds the equilibrium at the accepted time if the last accepted state is not one: a load has jumped, or
    // the stage begins with a state left by a motion.
    EquilibriumReport settle();
    // Whether a static stage that follows another one, or a step that begins here, settles first.
    virtual bool settles_after_stage() const { return false; }
    virtual bool settles_here() const { return false; }
    // Whether the stage follows another one and its motors and moved supports begin with the rates at which
    // that stage ended: then velocities that do not fit are round-off or errors of a scheme.
    bool takes_over_rates() const { return takes_over_rates_; }
    // Sets times at which an action jumps. Steps end there, with the values before the jump.
    void set_jumps(std::vector<double> jumps);
    const std::vector<double>& jumps() const { return jumps_; }
    // Settles where a load has jumped or a joint has broken; in a motion with inertia, solves for the
    // accelerations after a joint has broken, which the next step begins with.
    EquilibriumReport begin_anew();
    // Finds the trial motions at the end of the next step.
    virtual EquilibriumReport solve_trial();
    // Whether what follows the steps asks for the trial again.
    bool is_to_follow();
    // The time of the loads on the trial motions. On a path it is not the end of the step, and at a jump it
    // is just before.
    virtual double trial_time() const { return steps_->next_time(); }
    // Whether a load step whose work differs from its strain energy is solved again at load factors in
    // between.
    virtual bool looks_into_load_steps() const {
        return integrator_->is_static() && !system_.traits().is_driven;
    }
    // Store and restore the data that a kind of analysis needs in addition to resume; recalled after all the
    // rest.
    virtual void remember(RestartRecord&) const {}
    virtual void recall(const RestartRecord&) {}
    // Lets a kind of analysis reject a step that converged, by an outcome in the report.
    virtual void judge_equilibrium(EquilibriumReport&) {}
    // Tries the same step in another way, before a shorter step, or after the shortest one has failed.
    virtual bool tries_otherwise(const EquilibriumReport&, bool /*is_shortest*/) { return false; }
    // Whether relaxation found the trial; it dissipates the surplus of energy.
    virtual bool has_relaxed() const { return false; }
    // Notes data of an accepted equilibrium, before it is committed.
    virtual void note_equilibrium() {}
    // Negative pivots of the tangent at the last accepted equilibrium; −1 where none are counted.
    virtual std::int64_t accepted_pivots() const { return -1; }
    // The count of negative pivots for results: also −1 where it does not count unstable shapes.
    virtual std::int64_t counted_pivots() const { return accepted_pivots(); }
    virtual void resume_pivots(std::int64_t) {}

    ThreadTeam team_;
    System system_;
    std::unique_ptr<Integrator> integrator_;
    bool has_contrast_;  // contrast of stiffness: round-off may hide soft motions
    NewtonSettings newton_;
    LinearSolverKind linear_solver_;
    SolverWorkspace workspace_;
    std::unique_ptr<StepSequence> steps_;
    State state_;

  private:
    // Tries the next step. If it fails, or a load throws EvaluationError, the state is as before.
    bool take_step(EquilibriumReport& report);
    // Shortens the step. Returns false if the failed step is not to be tried again.
    bool shorten_step();
    Failure::Phase failure_phase() const;
    // Describes a motion that nothing resists at the last accepted state; "" if there is none.
    std::string find_weakness();
    // Adds the causes to the report of a failure.
    void find_reason(Failure& failure);
    // Finds an equilibrium beyond another one, without changing the state. The workspace has its residual
    // afterwards.
    std::optional<PathPoint> find_equilibrium(const PathPoint& from, double load_factor);
    // Keeps the step to the trial motions if its interior is wanted.
    void keep_step(double time);
    // Solves for equilibria within the load step that ends with the trial motions, if its work is unclear.
    void look_into_load_step(int iterations);
    // Fails the report if the estimated error is too large and steps are chosen by it.
    void check_error(EquilibriumReport& report);

    TriedStep tried_step();
    StepStart note_ledger_start() const;

    // Makes the next step end at the next jump or at the requested landing, whichever comes first.
    void aim();

    // A support whose prescribed place at this time differs from its node's place in the trial; nullptr if
    // there is none.
    struct SupportJump {
        const Support* support = nullptr;
        double distance = 0.0, angle = 0.0;
    };
    SupportJump find_support_jump(double time) const;
    void check_moved_supports() const;
    void check_motors() const;
    std::string describe_imbalance() const;

    std::unique_ptr<Ledger> ledger_;             // none before the start
    std::optional<Ledger> tried_ledger_;         // after the step that is tried, where energy is limited
    std::optional<LedgerTotals> totals_before_;  // totals of an earlier stage
    std::string start_note_;
    bool takes_over_rates_ = false;
    std::vector<double> jumps_;
    std::optional<double> landing_;  // requested by land_on
    std::optional<State> settled_;
    double lead_ = 0.0;  // as in StepMemory
    Stage last_stage_{}, settled_stage_{};
    int settled_parts_ = 0;
    bool is_settling_ = false;  // also after it has failed to settle
    long rejecting_step_ = -1;  // index of a nominal step
    int rejections_ = 0;        // rejections within this step; for a model with a contrast, in statics
    SolverRow solver_row_;
    CutTally cuts_;
    double largest_error_ = 0.0;
    double step_start_ = 0.0;
    std::function<bool(double from, double to)> is_wanted_;
    std::unique_ptr<StepInterior> interior_;  // interior of the last kept step
    std::vector<RodPlace> watched_;
    std::vector<ContactWatch> watched_contacts_;
    std::vector<PointValues> point_values_;
    std::vector<PointSurroundings> body_values_;
    std::vector<JointValues> joint_values_;
    TieValues ties_;
    std::vector<TendonValues> tendon_values_;
    ContactRecord contact_record_;
    StepFollower* follower_ = nullptr;
    std::vector<SectionValues> section_values_;
    std::vector<Vec6> reactions_;
};

}  // namespace gxrod
