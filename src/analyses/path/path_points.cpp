// What a path does about the critical points that its steps pass.
#include "analyses/path/branch_search.hpp"
#include "analyses/path/path.hpp"
#include "analyses/path/path_words.hpp"
#include "analyses/path/touch_events.hpp"
#include "check/summaries/direction_words.hpp"
#include "solvers/paired_matrix.hpp"
#include "solvers/path/soft_modes.hpp"

namespace gxrod {

PathContext PathAnalysis::exact_work() {
    PathContext exact = work();
    exact.newton.tolerance = std::min(1e-12, newton_.tolerance.value_or(usual_newton_tolerance));
    exact.newton.absolute_residual = 0.0;
    return exact;
}

bool PathAnalysis::look_for_critical_points() {
    if (settings_.critical == CriticalSearch::off || sense_ == 0) return true;
    const bool turns = trial_sense_ != sense_;
    const std::int64_t change = pivots_ < 0 || trial_.pivots < 0 ? 0 : trial_.pivots - pivots_;
    if (!turns && change == 0) return true;
    if (settings_.critical == CriticalSearch::locate) {
        const PathTrial end = trial_;
        const std::optional<LocatedPoint> located = locate(turns, change);
        const bool is_origin = located && !turns && is_still_at_origin();
        if (located && !is_origin && !branch_) {
            // The step to the point bends as none of its ends shows.
            PathTrial before = located->trial;
            PathContext search = exact_work();
            if (!hit_target(search, before)) return false;
            if (before.step != located->trial.step) {
                trial_ = before;
                trial_.pivots = pivots_;
                trial_sense_ = sense_;
                sequence().end_at(trial_.step);
                return true;
            }
        }
        if (!is_origin && keep(located)) return true;
        if (!is_origin && !sequence().is_short()) return false;
        // Back to where the step ended.
        PathContext search = exact_work();
        if (!solve_path_step(search, end.step * tangent_, metric_.row(tangent_), trial_).converged())
            return false;
        trial_ = end;
        if (is_origin) return true;
    }
    keep_unlocated(turns ? CriticalKind::limit : crossing_kind(),
                   std::max(1, static_cast<int>(std::abs(change))));
    return true;
}

// At a limit point both change, by one; elsewhere, if that is not several points in one step, the path
// crosses another one.
void PathAnalysis::look_for_symmetry() {
    constexpr double singular = 1e-9;  // of the next eigenvalue
    constexpr double away = 0.01;      // of arc length: at its start a branch is singular, too
    trial_is_singular_.reset();
    if (!has_pivots_ || is_regular_ || settings_.critical == CriticalSearch::off) return;
    if (!origin_.empty() && steps_->next_time() < away) return;
    if (!compute_path_tangent(
            system_, *integrator_, metric_, trial_.direction, trial_.load_factor, workspace_, state_))
        return;
    const LoneSoftness soft =
        estimate_lone_softness(factorized_tangent(system_, workspace_).solver, metric_.weights());
    trial_is_singular_ = soft.ratio < singular;
    if (!*trial_is_singular_) return;
    trial_.pivots = -1;
    if (was_singular_) symmetry_ = describe_symmetry(system_, soft.vector);
}

std::optional<LocatedPoint> PathAnalysis::locate(bool turns, std::int64_t change) {
    const PathTrial end = trial_;
    PathContext search = exact_work();
    if (!turns) return locate_bifurcation(search, tangent_, pivots_, end);
    if (!has_pivots_ || std::abs(change) == 1) return locate_limit(search, tangent_, end);
    return change == 0 ? locate_crossing(search, tangent_, pivots_, end) : std::nullopt;
}

bool PathAnalysis::keep(const std::optional<LocatedPoint>& located) {
    if (!located) return false;
    const bool is_limit = located->turns && located->trial.pivots != pivots_;
    CriticalPoint point;
    point.kind = is_limit || !has_pivots_ ? CriticalKind::limit : crossing_kind();
    point.multiplicity = located->multiplicity;
    point.pivots_before = pivots_;
    point.pivots_after = located->trial.pivots;
    point.load_factor = located->trial.load_factor;
    trial_ = located->trial;
    trial_sense_ = located->turns ? -sense_ : sense_;
    sequence().end_at(trial_.step);
    describe(point, located->kernel);
    trial_point_ = std::move(point);
    if (!located->turns && located->multiplicity == 1) {
        PathContext search = exact_work();
        FoundBranches found = find_branches(search, *located, pivots_, settings_);
        for (BranchStart& start : found.starts) start.point = points_.size();
        trial_point_->branching = found.branching;
        trial_branches_ = std::move(found.starts);
    }
    return true;
}

void PathAnalysis::keep_unlocated(CriticalKind kind, int multiplicity) {
    CriticalPoint point;
    point.kind = kind;
    point.is_located = false;
    point.multiplicity = multiplicity;
    point.pivots_before = pivots_;
    point.pivots_after = trial_.pivots;
    point.load_factor = trial_.load_factor;
    point.nodes = state_.trial;
    trial_point_ = std::move(point);
}

void PathAnalysis::describe(CriticalPoint& point, const Eigen::MatrixXd& kernel) {
    for (Eigen::Index i = 0; i < kernel.cols(); ++i) {
        std::vector<Vec6> shape(state_.trial.size());
        for (std::size_t node = 0; node < shape.size(); ++node)
            shape[node] = system_.equations().increment_of(static_cast<int>(node), kernel.col(i));
        point.kernel.push_back(std::move(shape));
    }
    point.nodes = state_.trial;
    compute_consistent_tangent(system_, *integrator_, point.load_factor, workspace_, state_);
    if (workspace_.is_paired) workspace_.paired->assemble();
    const FactorizedTangent tangent = factorized_tangent(system_, workspace_);
    const std::optional<Weakness> weakness =
        describe_weakness(system_, state_, tangent.pattern, tangent.values);
    if (weakness) point.shape = weakness->words;
}

bool PathAnalysis::look_for_touches() {
    trial_touch_.reset();
    if (!may_touch_ || branch_ || settings_.critical == CriticalSearch::off) return true;
    PathContext search = exact_work();
    TouchSearch touches(search, tangent_, trial_);
    if (!touches.found()) return true;
    const PathTrial end = trial_;
    CriticalPoint point;
    TouchEvent event = touches.list();
    if (settings_.critical == CriticalSearch::locate) {
        PathTrial located;
        const std::optional<TouchEvent> first = touches.locate(located);
        if (first) {
            event = *first;
            trial_ = located;
            sequence().end_at(trial_.step);
        } else {
            if (!sequence().is_short()) return false;
            if (!solve_path_step(search, end.step * tangent_, metric_.row(tangent_), trial_).converged())
                return false;
            trial_ = end;
        }
        point.is_located = first.has_value();
    } else {
        point.is_located = false;
    }
    point.kind = event.begins ? CriticalKind::touch : CriticalKind::release;
    point.multiplicity = 0;
    point.shape = name_touching(system_.model(), event.things);
    trial_touch_ = std::move(point);
    touch_step_ = trial_.step;
    return true;
}

void PathAnalysis::keep_touch() {
    if (!trial_touch_ || trial_point_ || trial_.step != touch_step_) return;
    trial_touch_->pivots_before = pivots_;
    trial_touch_->pivots_after = trial_.pivots;
    trial_touch_->load_factor = trial_.load_factor;
    trial_touch_->nodes = state_.trial;
    trial_point_ = std::move(trial_touch_);
}

std::vector<std::string> PathAnalysis::list_findings() const {
    if (settings_.limit_load_factor) return {describe_followed_limit(state_.time, limit_load_factor_)};
    std::vector<std::string> findings = describe_critical_points(points_, branches_, has_potential_);
    // A main path that is not at its end fails.
    if (!symmetry_.empty() && finished()) findings.push_back(symmetry_);
    return findings;
}

}  // namespace gxrod
