#include "analyses/path/path.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

#include "assembly/contact/contacts.hpp"
#include "integrators/load_stepping.hpp"
#include "model/settings/newton_choice.hpp"
#include "solvers/paired_matrix.hpp"

namespace gxrod {

namespace {

NewtonSettings choose_path_newton(const Model& model, const PathSettings& settings) {
    StaticSettings as_static;
    as_static.newton = settings.newton;
    return choose_newton(model, as_static);
}

// Where contact begins a path turns by a right angle or more, within a part of the skin that is as small as
// the structure is soft compared with contact.
PathSettings choose_steps(const Model& model, PathSettings settings) {
    constexpr double round_corners = 1e-10;
    if (!model.contact.is_empty() && settings.min_step == PathSettings{}.min_step)
        settings.min_step = round_corners;
    return settings;
}

// Of the model's length: two places that are nearer are one.
constexpr double at_origin = 1e-5;

int sign_of(double value) { return value < 0.0 ? -1 : 1; }

}  // namespace

PathAnalysis::PathAnalysis(const Model& model, const PathSettings& settings, int threads)
    : SteppedAnalysis(model,
                      threads,
                      std::make_unique<LoadStepping>(),
                      choose_path_newton(model, settings),
                      settings.linear_solver,
                      std::make_unique<PathSequence>(choose_steps(model, settings))),
      settings_(settings),
      metric_(system_),
      targets_(system_, settings),
      counter_(system_),
      has_potential_(find_load_without_potential(model).empty()),
      may_touch_(Contacts(system_).are_possible()),
      has_pivots_(!has_contrast_ && !settings.limit_load_factor) {
    if (!settings.least_load && !settings.greatest_load && !settings.arc && !settings.steps &&
        !settings.points)
        throw std::invalid_argument("nothing ends the path");
    if (settings_.control) control_ = targets_.row_of(*settings_.control);
    // Borders need the factors of the whole matrix.
    if (workspace_.paired && settings.linear_solver == LinearSolverKind::automatic)
        workspace_.paired = std::make_unique<PairedMatrix>(system_, LinearSolverKind::chains);
    if (!settings_.limit_load_factor) return;
    // All of its points are critical.
    settings_.critical = CriticalSearch::off;
    limit_load_factor_ = *settings_.limit_load_factor;
}

void PathAnalysis::restore_limit_load() {
    if (!settings_.limit_load_factor || *settings_.limit_load_factor == limit_load_factor_) return;
    *settings_.limit_load_factor = limit_load_factor_;
    system_.forget_loads();
}

PathContext PathAnalysis::work() {
    PathContext context{system_, *integrator_, newton_, metric_, has_potential_, workspace_, state_};
    context.limit_load_factor = settings_.limit_load_factor.get();
    return context;
}

double PathAnalysis::control_rate(const PathVector& direction) const {
    return std::abs(control_->u.dot(direction.u));
}

EquilibriumReport PathAnalysis::solve_trial() {
    constexpr double slow = 0.05;  // of the largest rate: the displacement is about to turn back
    trial_point_.reset();
    trial_touch_.reset();
    trial_branches_.clear();
    trial_ = {};
    trial_.step = steps_->time_step();
    if (branch_) return solve_branch_trial();
    // The tangent gives no direction.
    if (!symmetry_.empty()) throw std::runtime_error(symmetry_);
    if (sequence().is_crawling()) {
        EquilibriumReport report;
        report.outcome = Outcome::path_crawls;
        return report;
    }
    restore_limit_load();
    PathContext search = settings_.limit_load_factor ? exact_work() : work();
    EquilibriumReport report = solve_path_step(search, trial_.step * tangent_, step_row(), trial_);
    if (control_ && !report.converged() && control_rate(tangent_) < slow * largest_control_rate_)
        report.outcome = Outcome::control_turned;
    return report;
}

EquilibriumReport PathAnalysis::solve_branch_trial() {
    // The shape resists hardly at all there, so that little residual is a long way.
    PathContext search = exact_work();
    EquilibriumReport report;
    const std::optional<PathTrial> found = step_on_branch(search, *branch_, steps_->time_step());
    report.iterations = search.iterations;
    if (!found) {
        report.outcome = Outcome::out_of_iterations;
        return report;
    }
    trial_ = *found;
    trial_.effort = report.iterations;
    report.negative_pivots = trial_.pivots;
    report.residual = trial_.residual;
    sequence().end_at(trial_.step);
    return report;
}

void PathAnalysis::judge_equilibrium(EquilibriumReport& report) {
    judge_trial(report);
    if (!report.converged()) restore_limit_load();
}

bool PathAnalysis::hit_target(PathContext& search, PathTrial& trial) const {
    // Along limit points directions are those of chords, which say nothing of how a step bends.
    const PathVector& direction = settings_.limit_load_factor ? trial.direction : tangent_;
    return targets_.hit(search, {direction, step_row(), sequence().is_short()}, trial);
}

void PathAnalysis::judge_trial(EquilibriumReport& report) {
    // Forces of contact are so stiff that the last iteration's direction is not good enough.
    if (may_touch_) take_exact_tangent();
    // Up to there the path is as smooth as before.
    if (!look_for_touches()) {
        report.outcome = Outcome::lost_stability;
        return;
    }
    const double cosine = metric_.multiply(trial_.direction, tangent_);
    const bool can_shorten = !sequence().is_shortest();
    if (!branch_ && can_shorten && cosine < std::cos(widest_path_angle)) {
        report.outcome = Outcome::lost_stability;
        return;
    }
    PathContext search = settings_.limit_load_factor ? exact_work() : work();
    const double whole = trial_.step;
    const int effort = trial_.effort;
    if (!branch_ && !hit_target(search, trial_)) {
        report.outcome = Outcome::lost_stability;
        return;
    }
    if (trial_.step != whole) sequence().end_at(trial_.step);
    report.negative_pivots = trial_.pivots;
    trial_sense_ = sign_of(trial_.direction.load);
    count_pivots(report);
    look_for_symmetry();
    sequence().adapt(effort);
    if (!look_for_critical_points()) report.outcome = Outcome::lost_stability;
    keep_touch();
    report.residual = trial_.residual;
    report.iterations += search.iterations;
}

void PathAnalysis::count_pivots(EquilibriumReport& report) {
    if (!has_pivots_) {
        trial_.pivots = -1;
        return;
    }
    constexpr int few = 2;
    const bool changes = trial_.pivots != pivots_ || (sense_ != 0 && trial_sense_ != sense_);
    if (!changes && report.iterations > few && !may_touch_) return;
    // The last iteration's tangent was that of the iterate before.
    if (!take_exact_tangent()) return;
    trial_sense_ = sign_of(trial_.direction.load);
    if (trial_.pivots != pivots_)
        trial_.pivots =
            counter_.count(*integrator_, {0, state_.time, 0.0, trial_.load_factor}, workspace_, state_);
}

bool PathAnalysis::take_exact_tangent() {
    const std::optional<PathTangent> exact = compute_path_tangent(
        system_, *integrator_, metric_, trial_.direction, trial_.load_factor, workspace_, state_);
    if (!exact) return false;
    trial_.direction = exact->direction;
    trial_.pivots = exact->negative_pivots;
    return true;
}

// By how far the farthest node of the trial is from where it was where the branch began, of the model's
// length.
double PathAnalysis::distance_from_origin() const {
    double farthest = 0.0;
    for (std::size_t i = 0; i < origin_.size(); ++i)
        farthest = std::max(farthest, (origin_[i].r - state_.trial[i].r).norm());
    return farthest / system_.length_scale();
}

// Until a branch has left the bifurcation at which it begins, what softens there is that one.
bool PathAnalysis::is_still_at_origin() const {
    return !origin_.empty() && !has_left_origin_ && distance_from_origin() < at_origin;
}

// A loop begins and ends at the same bifurcation.
bool PathAnalysis::is_closed() const {
    if (!has_left_origin_ || points_.empty() || !is_critical(points_.back().kind)) return false;
    if (points_.back().step != steps_->steps_done() + 1) return false;
    return distance_from_origin() < at_origin;
}

void PathAnalysis::note_equilibrium() {
    tangent_ = trial_.direction;
    if (control_) largest_control_rate_ = std::max(largest_control_rate_, control_rate(tangent_));
    pivots_ = trial_.pivots;
    sense_ = trial_sense_;
    if (settings_.limit_load_factor) limit_load_factor_ = *settings_.limit_load_factor;
    if (trial_is_singular_) (*trial_is_singular_ ? was_singular_ : is_regular_) = true;
    branch_.reset();
    if (trial_point_) {
        trial_point_->step = steps_->steps_done() + 1;
        trial_point_->arc_length = steps_->next_time();
        points_.push_back(std::move(*trial_point_));
        trial_point_.reset();
        for (BranchStart& start : trial_branches_) branches_.push_back(std::move(start));
        trial_branches_.clear();
    }
    const bool is_back = is_closed();
    if (!origin_.empty() && distance_from_origin() >= at_origin) has_left_origin_ = true;
    note_progress(trial_.load_factor);
    if (is_back || (!origin_.empty() && !symmetry_.empty())) sequence().finish();
}

std::int64_t PathAnalysis::critical_count() const {
    return points_before_ +
           std::ranges::count_if(points_, [](const CriticalPoint& point) { return is_critical(point.kind); });
}

void PathAnalysis::note_progress(double load_factor) {
    const std::int64_t count = critical_count();
    double part =
        settings_.points ? static_cast<double>(count) / static_cast<double>(*settings_.points) : 0.0;
    for (const auto& bound : {settings_.least_load, settings_.greatest_load}) {
        if (bound && *bound != 0.0) part = std::max(part, load_factor / *bound);
    }
    sequence().note_part(part);
    if (targets_.is_end(state_.trial, load_factor) || (settings_.points && count >= *settings_.points))
        sequence().finish();
}

void PathAnalysis::remember(RestartRecord& record) const {
    PathMemory& memory = record.path;
    memory.load_factor = state_.time;
    memory.load_scale = metric_.load_scale();
    memory.load_rate = tangent_.load;
    memory.tangent.resize(state_.previous.size());
    for (std::size_t node = 0; node < memory.tangent.size(); ++node)
        memory.tangent[node] = system_.equations().increment_of(static_cast<int>(node), tangent_.u);
    memory.load_sense = sense_;
    memory.points = critical_count();
}

void PathAnalysis::recall(const RestartRecord& record) {
    const PathMemory& memory = record.path;
    if (memory.tangent.size() != state_.previous.size())
        throw std::invalid_argument("the state to resume from is not on a path of this model");
    state_.time = memory.load_factor;
    metric_.set_load_scale(memory.load_scale);
    tangent_ = {gather(memory.tangent, system_.equations()), memory.load_rate};
    sense_ = static_cast<int>(memory.load_sense);
    points_before_ = memory.points;
    if (steps_->steps_done() > 0) note_progress(memory.load_factor);
}

}  // namespace gxrod
