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

// Equilibria along a path on which the load factor may turn back; the time of its steps is the arc length
// (docs/theory/paths.md).
class PathAnalysis : public SteppedAnalysis {
  public:
    // The model must outlive the analysis. Throws std::invalid_argument if nothing ends the path.
    PathAnalysis(const Model& model, const PathSettings& settings, int threads = 1);

    // From the reference shape, or where an earlier stage left it, with the load factor 0.
    EquilibriumReport start() override;
    // Instead: from a bifurcation of another path of the same model, along the branch.
    EquilibriumReport start(const BranchStart& branch);

    double axis_time() const override { return steps_->time(); }
    // Of the last accepted equilibrium.
    PathRow row() const { return {state_.time, tangent_.load}; }
    // In their order along the path; and the branches that leave it at them, both sides of each.
    const std::vector<CriticalPoint>& critical_points() const { return points_; }
    const std::vector<BranchStart>& branches() const { return branches_; }
    const PathMetric& metric() const { return metric_; }
    // The critical points of this run of it.
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
    // Of a more exact search.
    PathContext exact_work();
    PathSequence& sequence() { return static_cast<PathSequence&>(*steps_); }
    const PathSequence& sequence() const { return static_cast<const PathSequence&>(*steps_); }
    // The path's first direction, at the start; and what follows from how the unknowns follow the load
    // factor.
    EquilibriumReport find_first_direction();
    // Whether the load factor falls first, whose growth by 1 moves the unknowns by `rate`.
    bool falls_first(const Eigen::VectorXd& rate) const;
    void set_first_direction(const Eigen::VectorXd& rate);
    EquilibriumReport start_at_limit();
    EquilibriumReport solve_branch_trial();
    PathVector step_row() const { return control_ ? *control_ : metric_.row(tangent_); }
    // False if the step to this trial passes a target that was not found; else it ends on the first of them.
    bool hit_target(PathContext& search, PathTrial& trial) const;
    // How the controlling displacement changes along a direction.
    double control_rate(const PathVector& direction) const;
    void judge_trial(EquilibriumReport& report);
    // The load factor of a followed limit point, at the last accepted one.
    void restore_limit_load();
    // A pivot count that can be compared with that of the last accepted equilibrium.
    void count_pivots(EquilibriumReport& report);
    // Whether the tangent is singular at the first equilibria, whatever the path does: the model has a
    // continuous symmetry.
    void look_for_symmetry();
    // How far it is from what ends it, and whether it is there.
    void note_progress(double load_factor);
    double distance_from_origin() const;
    bool is_still_at_origin() const;
    // Whether a branch has come back to where it began.
    bool is_closed() const;
    // Which critical points the step has passed; false if a shorter step has to find out.
    bool look_for_critical_points();
    std::optional<LocatedPoint> locate(bool turns, std::int64_t change);
    bool keep(const std::optional<LocatedPoint>& located);
    // What a point is where an eigenvalue of the tangent passes or touches zero.
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
    std::optional<BranchStart> branch_;  // until its first step is taken
    std::vector<NodeMotion> origin_;     // of a branch
    bool has_left_origin_ = false;       // by more than round-off
    // At the last accepted equilibrium.
    PathVector tangent_;
    std::int64_t pivots_ = -1;
    int sense_ = 1;  // of the load factor beyond it; 0: not known
    double limit_load_factor_ = 0.0;
    std::optional<PathVector> control_;  // of a path under control: the row of what controls it
    double largest_control_rate_ = 0.0;  // of the steps so far
    // At the trial one.
    PathTrial trial_;
    int trial_sense_ = 1;
    bool has_pivots_ = true;  // whether they are counted at all
    // Of the tangent at the first equilibria; once one is regular, no more are examined.
    bool is_regular_ = false;
    bool was_singular_ = false;
    std::optional<bool> trial_is_singular_;
    std::string symmetry_ = {};  // of a path on which the tangent is singular everywhere, what to do
    std::optional<CriticalPoint> trial_point_;
    std::vector<BranchStart> trial_branches_;

    std::vector<CriticalPoint> points_;
    std::int64_t points_before_ = 0;  // of the run that is resumed
    std::vector<BranchStart> branches_;
};

}  // namespace gxrod
