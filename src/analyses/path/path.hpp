#pragma once

#include "analyses/path/branch_switch.hpp"
#include "analyses/path/critical_points.hpp"
#include "analyses/path/path_targets.hpp"
#include "analyses/stepped_analysis.hpp"
#include "check/motions/stability.hpp"
#include "model/settings/settings.hpp"
#include "solvers/path/path_sequence.hpp"
#include "state/records/path_record.hpp"

namespace gxrod {

// Finds equilibria along a path on which the load factor may turn back; the time of its steps is the arc
// length (docs/theory/paths.md).
class PathAnalysis : public SteppedAnalysis {
  public:
    // The model must outlive the analysis. Throws std::invalid_argument if nothing ends the path.
    PathAnalysis(const Model& model, const PathSettings& settings, int threads = 1);

    // Starts from the reference shape, or from the end of an earlier stage, with the load factor 0.
    EquilibriumReport start() override;
    // Starts from a bifurcation of another path of the same model, along the branch.
    EquilibriumReport start(const BranchStart& branch);

    double axis_time() const override { return steps_->time(); }
    // The row of results for the last accepted equilibrium.
    PathRow row() const { return {state_.time, tangent_.load}; }
    // The critical points in their order along the path, and the branches that leave the path there, both
    // sides of each.
    const std::vector<CriticalPoint>& critical_points() const { return points_; }
    const std::vector<BranchStart>& branches() const { return branches_; }
    const PathMetric& metric() const { return metric_; }
    // Lists the critical points of this run.
    std::vector<std::string> list_findings() const override;
    bool is_unstable() const override { return has_potential_ && pivots_ > 0; }

  protected:
    EquilibriumReport solve_trial() override;
    double trial_time() const override { return trial_.load_factor; }
    bool looks_into_load_steps() const override { return false; }
    void judge_equilibrium(EquilibriumReport& report) override;
    void note_equilibrium() override;
    std::int64_t accepted_pivots() const override { return pivots_; }
    std::int64_t counted_pivots() const override { return has_potential_ ? pivots_ : -1; }
    void resume_pivots(std::int64_t pivots) override { pivots_ = pivots; }
    void remember(RestartRecord& record) const override;
    void recall(const RestartRecord& record) override;

  private:
    PathContext work();
    // Returns the context of a more exact search.
    PathContext exact_work();
    PathSequence& sequence() { return static_cast<PathSequence&>(*steps_); }
    const PathSequence& sequence() const { return static_cast<const PathSequence&>(*steps_); }
    // Finds the path's first direction, at the start, and sets it from the rate of the unknowns by the load
    // factor.
    EquilibriumReport find_first_direction();
    // Whether the load factor falls first; the unknowns change by `rate` while it grows by 1.
    bool falls_first(const Eigen::VectorXd& rate) const;
    void set_first_direction(const Eigen::VectorXd& rate);
    EquilibriumReport start_at_limit();
    EquilibriumReport solve_branch_trial();
    PathVector step_row() const { return control_ ? *control_ : metric_.row(tangent_); }
    // Ends the step on the first target that it passes. Returns false if that target was not found.
    bool hit_target(PathContext& search, PathTrial& trial) const;
    // Computes the rate of the controlling displacement along a direction.
    double control_rate(const PathVector& direction) const;
    void judge_trial(EquilibriumReport& report);
    // Restores the load factor of a followed limit point to its value at the last accepted one.
    void restore_limit_load();
    // Takes the trial's direction and pivots from the consistent tangent at the trial; returns false if that
    // has no inverse.
    bool take_exact_tangent();
    // Counts pivots so that the count can be compared with the last accepted equilibrium.
    void count_pivots(EquilibriumReport& report);
    // Finds whether the tangent is singular at the first equilibria, independently of the path: then the
    // model has a continuous symmetry.
    void look_for_symmetry();
    // Notes how far the path is from its end, and whether it has reached it.
    void note_progress(double load_factor);
    double distance_from_origin() const;
    bool is_still_at_origin() const;
    // Whether a branch has come back to its beginning.
    bool is_closed() const;
    // Finds the critical points that the step has passed; returns false if a shorter step has to find out.
    bool look_for_critical_points();
    // Ends the step where things begin or cease to touch; returns false if a shorter step has to find out.
    bool look_for_touches();
    // Keeps such an event of the step, unless the step ends earlier.
    void keep_touch();
    std::int64_t critical_count() const;
    std::optional<LocatedPoint> locate(bool turns, std::int64_t change);
    bool keep(const std::optional<LocatedPoint>& located);
    // The kind of a point at which an eigenvalue of the tangent passes or touches zero.
    CriticalKind crossing_kind() const {
        return has_potential_ ? CriticalKind::bifurcation : CriticalKind::divergence;
    }
    void keep_unlocated(CriticalKind kind, int multiplicity);
    void describe(CriticalPoint& point, const Eigen::MatrixXd& kernel);

    PathSettings settings_;
    PathMetric metric_;
    PathTargets targets_;
    PivotCounter counter_;
    bool has_potential_;
    bool may_touch_;
    std::optional<BranchStart> branch_;  // until its first step is taken
    std::vector<NodeMotion> origin_;     // start of a branch
    bool has_left_origin_ = false;       // by more than round-off
    // Values at the last accepted equilibrium.
    PathVector tangent_;
    std::int64_t pivots_ = -1;
    int sense_ = 1;  // sign of the load factor's change beyond it; 0: not known
    double limit_load_factor_ = 0.0;
    std::optional<PathVector> control_;  // under control: the row of the controlling component
    double largest_control_rate_ = 0.0;  // over the steps so far
    // Values at the trial equilibrium.
    PathTrial trial_;
    int trial_sense_ = 1;
    bool has_pivots_ = true;  // whether pivots are counted at all
    // Whether the tangent is regular at the first equilibria; once one is regular, no more are examined.
    bool is_regular_ = false;
    bool was_singular_ = false;
    std::optional<bool> trial_is_singular_;
    std::string symmetry_ = {};  // advice for a path on which the tangent is singular everywhere
    std::optional<CriticalPoint> trial_point_;
    std::optional<CriticalPoint> trial_touch_;
    double touch_step_ = 0.0;  // the step that ends at trial_touch_
    std::vector<BranchStart> trial_branches_;

    std::vector<CriticalPoint> points_;
    std::int64_t points_before_ = 0;  // points of the run before it was resumed
    std::vector<BranchStart> branches_;
};

}  // namespace gxrod
