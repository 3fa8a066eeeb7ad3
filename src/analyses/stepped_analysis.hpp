#pragma once

#include <functional>
#include <memory>

#include "analyses/cut_tally.hpp"
#include "analyses/ledger.hpp"
#include "analyses/path_work.hpp"
#include "analyses/step_interior.hpp"
#include "assembly/system.hpp"
#include "check/failure_advice.hpp"
#include "integrators/integrator.hpp"
#include "solvers/equilibrium.hpp"
#include "solvers/steps/step_sequence.hpp"
#include "state/records/step_record.hpp"

namespace gxrod {

// What all analyses in steps do: one step after the other, repeating one that fails with a shorter one.
class SteppedAnalysis {
  public:
    virtual ~SteppedAnalysis() = default;

    // Prepares the first step; before anything else.
    virtual EquilibriumReport start() = 0;
    // The same from the state in which an earlier stage left the same mesh. Throws std::runtime_error if a
    // support that moves would have to jump there.
    EquilibriumReport start_after(const SteppedAnalysis& before);
    // Instead of the start and all steps, in statics: the equilibrium under what acts at this time, by
    // Newton's method from the state of an analysis of the same mesh. The books begin there.
    EquilibriumReport settle_after(const SteppedAnalysis& before, double time);
    // What is to be known of that start, a clause; "" if nothing: a motion that does not begin in
    // equilibrium.
    const std::string& start_note() const { return start_note_; }
    // One accepted step, as long as the sequence of steps has it. If even the shortest step fails, the report
    // says why and the state is the last accepted one.
    EquilibriumReport advance();
    bool finished() const { return steps_->finished(); }
    // As StepSequence::land_on.
    std::optional<double> land_on(double time);

    // The last accepted step, to resume from later; totals are left to the caller.
    RestartRecord restart_record() const;
    // Instead of start(): resumes from there. False if no step of this analysis can begin at that time.
    // Throws std::invalid_argument if the record is of another model.
    bool resume(const RestartRecord& record);

    // Why the start or the last step failed, where, and what to try. Its report must be the last one.
    Failure explain(const EquilibriumReport& report);

    const System& system() const { return system_; }
    // What a frame adds to the matrices about the state, if the model turns with one.
    const FrameColumns* frame() const { return workspace_.frame; }
    const State& state() const { return state_; }
    const StepSequence& steps() const { return *steps_; }
    const PhaseSeconds& seconds() const { return workspace_.seconds; }

    // Warnings about the steps so far, a sentence each.
    virtual std::vector<std::string> list_warnings() const { return {}; }
    // What the steps so far have found that calls for no change of the deck, a sentence each.
    virtual std::vector<std::string> list_findings() const { return {}; }
    // Whether unstable equilibria were accepted.
    virtual bool is_unstable() const { return false; }

    LedgerRow ledger_row() const { return ledger_->row(state_); }
    const SolverRow& solver_row() const { return solver_row_; }
    // Of the steps since the start, or since it was resumed.
    const CutTally& cuts() const { return cuts_; }
    // Of the trials: the largest estimated error, 0 if the scheme estimates none; and what Newton's
    // method was asked for.
    double largest_error() const { return largest_error_; }
    const NewtonSettings& newton() const { return newton_; }
    // Points of rods, and contacts of rods, that snapshots record; before the start.
    void watch(std::vector<RodPlace> places, std::vector<ContactWatch> contacts = {}) {
        watched_ = std::move(places);
        watched_contacts_ = std::move(contacts);
    }
    // Of snapshots: of the loads, or another axis that grows from step to step.
    virtual double axis_time() const { return state_.time; }
    // Of the last accepted state; valid until the next step. With the sections of all elements only if asked
    // for.
    Snapshot snapshot(bool with_elements = true);
    // Keeps steps for which this holds, of their ends, so that they can be looked into.
    void keep_steps(std::function<bool(double from, double to)> is_wanted) {
        is_wanted_ = std::move(is_wanted);
    }
    // At a time within the last accepted step, which must have been kept; valid until the next call or step.
    Snapshot snapshot_within(double time, bool with_elements = true) {
        return interior_->snapshot(time, with_elements, watched_, watched_contacts_);
    }
    // The state that the start or the last step settled in before anything else; nullptr if it did not.
    const State* settled() const { return settled_ ? &*settled_ : nullptr; }
    // The last accepted step as the scheme took it.
    const Stage& last_stage() const { return last_stage_; }
    const Stage& settled_stage() const { return settled_stage_; }
    // In how many parts, each from the state that the one before left.
    int settled_parts() const { return settled_parts_; }
    // How it settles.
    virtual Stage settling_stage() const { return {0, steps_->time(), 0.0, steps_->time()}; }
    virtual const Integrator& settling_integrator() const { return *integrator_; }
    // Where the last accepted step began.
    double step_start() const { return step_start_; }
    // Of what acts from outside on the last accepted state; in dynamics it is the rate of the momenta.
    Resultant outer_resultant() const {
        return system_.compute_outer_resultant(state_, state_.time, reactions_);
    }

  protected:
    // The model must outlive the analysis; so many threads share its work.
    SteppedAnalysis(const Model& model,
                    int threads,
                    std::unique_ptr<Integrator> integrator,
                    const NewtonSettings& newton,
                    LinearSolverKind linear_solver,
                    std::unique_ptr<StepSequence> steps);

    // Takes the trial motions for the state at the start, at t = 0 or this time of the loads; the workspace
    // has their residual. Loads that act there already have done no work yet.
    void accept_start(double time = 0.0, bool is_loaded = false);
    // The same at t = 0, without velocities and accelerations.
    EquilibriumReport start_at_rest();
    // Throws std::runtime_error where rods are in what they touch; before any force is asked for.
    void refuse_overlaps(double time);
    // The first stage of the next step.
    Stage next_stage() const;
    // Goes to the equilibrium at the accepted time, if the last accepted state is not one: a load has come at
    // once, or a stage begins with what a motion leaves.
    EquilibriumReport settle();
    // Whether a static stage that follows another one, or a step that begins here, is to settle first.
    virtual bool settles_after_stage() const { return false; }
    virtual bool settles_here() const { return false; }
    // Whether the stage follows another one, and what moves joints and supports begins with the rates at
    // which that ended: then what velocities do not fit is round-off, or what a scheme leaves.
    bool takes_over_rates() const { return takes_over_rates_; }
    // Times at which something that acts jumps: steps end there, with what acts before.
    void set_jumps(std::vector<double> jumps);
    const std::vector<double>& jumps() const { return jumps_; }
    // Finds the trial motions at the end of the next step.
    virtual EquilibriumReport solve_trial();
    // Of the loads that act on them. On a path it is not the end of the step, and where something jumps it is
    // just before.
    virtual double trial_time() const { return steps_->next_time(); }
    // Whether a load step whose work parts from its strain energy is looked into at load factors in between.
    virtual bool looks_into_load_steps() const { return integrator_->is_static() && !system_.is_driven(); }
    // What a kind of analysis needs in addition to resume; recalled after all the rest.
    virtual void remember(RestartRecord&) const {}
    virtual void recall(const RestartRecord&) {}
    // Lets a kind of analysis reject a step that converged, as an outcome of the report …
    virtual void judge_equilibrium(EquilibriumReport&) {}
    // … try the same step in another way, before a shorter one, or after the shortest one has failed …
    virtual bool tries_otherwise(const EquilibriumReport&, bool /*is_shortest*/) { return false; }
    // … say that the trial was found by relaxation, which takes the energy that is over …
    virtual bool has_relaxed() const { return false; }
    // … and note what it needs of an accepted one, before it is committed.
    virtual void note_equilibrium() {}
    // Negative pivots of the tangent at the last accepted equilibrium; −1 where none are counted.
    virtual std::int64_t accepted_pivots() const { return -1; }
    // What results say of them: −1 as well where they do not count unstable shapes.
    virtual std::int64_t counted_pivots() const { return accepted_pivots(); }
    virtual void resume_pivots(std::int64_t) {}

    ThreadTeam team_;
    System system_;
    std::unique_ptr<Integrator> integrator_;
    bool has_contrast_;  // of stiffness, so that round-off may hide what is soft
    NewtonSettings newton_;
    LinearSolverKind linear_solver_;
    SolverWorkspace workspace_;
    std::unique_ptr<StepSequence> steps_;
    State state_;

  private:
    // Tries the next step; if that fails, or a load throws EvaluationError, the state is as before.
    bool take_step(EquilibriumReport& report);
    // False if the step that failed is not to be tried with a shorter one.
    bool shorten_step();
    Failure::Phase failure_phase() const;
    // The motion that nothing resists at the last accepted state, or "".
    std::string find_weakness();
    // Completes the report of a failure with its causes.
    void find_reason(Failure& failure);
    // An equilibrium beyond another one, apart from the state. The workspace has its residual afterwards.
    std::optional<PathPoint> find_equilibrium(const PathPoint& from, double load_factor);
    // Of the trial motions, if what lies within the step is wanted.
    void keep_step(double time);
    // Of the trial motions, which are the end of a load step.
    void look_into_load_step(int iterations);
    // Fails the report if the step's estimated error is too large for steps that are chosen by it.
    void check_error(EquilibriumReport& report);

    // Has the next step end at the next jump, or where it was told to, whichever comes first.
    void aim();

    // A support whose move at this time is not where its node is in the trial; nullptr without any.
    struct SupportJump {
        const Support* support = nullptr;
        double distance = 0.0, angle = 0.0;
    };
    SupportJump find_support_jump(double time) const;
    void check_moved_supports() const;
    void check_motors() const;
    std::string describe_imbalance() const;

    std::unique_ptr<Ledger> ledger_;             // none before the start
    std::optional<LedgerTotals> totals_before_;  // of an earlier stage
    std::string start_note_;
    bool takes_over_rates_ = false;
    std::vector<double> jumps_;
    std::optional<double> landing_;  // asked for by land_on
    std::optional<State> settled_;
    double lead_ = 0.0;  // as StepMemory has it
    Stage last_stage_{}, settled_stage_{};
    int settled_parts_ = 0;
    bool is_settling_ = false;  // or has failed to
    long rejecting_step_ = -1;  // of the nominal steps
    int rejections_ = 0;        // within it; of a model with a contrast, in statics
    SolverRow solver_row_;
    CutTally cuts_;
    double largest_error_ = 0.0;
    double step_start_ = 0.0;
    std::function<bool(double from, double to)> is_wanted_;
    std::unique_ptr<StepInterior> interior_;  // of the last step that was kept
    std::vector<RodPlace> watched_;
    std::vector<ContactWatch> watched_contacts_;
    std::vector<PointValues> point_values_;
    std::vector<PointSurroundings> body_values_;
    std::vector<JointValues> joint_values_;
    std::vector<TendonValues> tendon_values_;
    ContactRecord contact_record_;
    std::vector<SectionValues> section_values_;
    std::vector<Vec6> reactions_;
};

}  // namespace gxrod
