#include "analyses/path.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "check/direction_words.hpp"
#include "integrators/load_stepping.hpp"
#include "model/newton_choice.hpp"
#include "solvers/newton_steps.hpp"

namespace gxrod {

namespace {

// Between the directions at both ends of a step.
constexpr double widest_angle = 25.0 * std::numbers::pi / 180.0;
// The first step moves the model by so much, and the load factor by this part of its range.
constexpr double first_movement = 0.05;
constexpr double first_part = 0.1;

NewtonSettings choose_path_newton(const Model& model, const PathSettings& settings) {
    StaticSettings as_static;
    as_static.newton = settings.newton;
    return choose_newton(model, as_static);
}

int sign_of(double value) { return value < 0.0 ? -1 : 1; }

}  // namespace

PathAnalysis::PathAnalysis(const Model& model, const PathSettings& settings, int threads)
    : SteppedAnalysis(model,
                      threads,
                      std::make_unique<LoadStepping>(),
                      choose_path_newton(model, settings),
                      settings.linear_solver,
                      std::make_unique<PathSequence>(settings)),
      settings_(settings),
      metric_(system_),
      targets_(system_, settings),
      counter_(system_),
      has_potential_(find_load_without_potential(model).empty()),
      has_pivots_(!has_contrast_) {
    if (!settings.least_load && !settings.greatest_load && !settings.arc && !settings.steps &&
        !settings.points)
        throw std::invalid_argument("nothing ends the path");
}

PathContext PathAnalysis::work() {
    return {system_, *integrator_, newton_, metric_, has_potential_, workspace_, state_};
}

PathContext PathAnalysis::exact_work() {
    PathContext exact = work();
    exact.newton.tolerance = std::min(1e-12, newton_.tolerance.value_or(usual_newton_tolerance));
    exact.newton.absolute_residual = 0.0;
    return exact;
}

EquilibriumReport PathAnalysis::start() {
    for (NodeMotion& motion : state_.trial) {
        motion.v.setZero();
        motion.omega.setZero();
    }
    state_.previous = state_.trial;
    // What acts at t = 0 already acts before the path begins.
    EquilibriumReport report =
        solve_equilibrium(system_, *integrator_, newton_, {0, 0.0, 0.0, 0.0}, workspace_, state_);
    if (!report.converged()) return report;
    const bool is_loaded = report.iterations > 0;
    accept_start(0.0, is_loaded);
    return find_first_direction();
}

EquilibriumReport PathAnalysis::find_first_direction() {
    EquilibriumReport report;
    compute_consistent_tangent(system_, *integrator_, state_.time, workspace_, state_);
    if (!factorize(system_, workspace_, report)) return report;
    Eigen::VectorXd rate = -compute_load_gradient(system_, state_.time, workspace_.residual, state_);
    workspace_.linear_solver->solve(rate);
    if (!rate.allFinite()) {
        report.outcome = Outcome::not_finite;
        return report;
    }
    metric_.scale_load(rate);
    const bool falls = settings_.least_load && !settings_.greatest_load;
    tangent_ = {rate, 1.0};
    tangent_ = ((falls ? -1.0 : 1.0) / metric_.norm(tangent_)) * tangent_;
    sense_ = falls ? -1 : 1;
    pivots_ = has_pivots_
                  ? counter_.count(*integrator_, {0, state_.time, 0.0, state_.time}, workspace_, state_)
                  : -1;
    const double range = std::max(std::abs(settings_.greatest_load.value_or(falls ? 0.0 : 1.0)),
                                  std::abs(settings_.least_load.value_or(0.0)));
    const double step =
        std::min(first_movement * std::numbers::sqrt2, first_part * range / std::abs(tangent_.load));
    sequence().start(step);
    return report;
}

EquilibriumReport PathAnalysis::start(const BranchStart& branch) {
    state_ = branch.state;
    branch_ = branch;
    origin_ = branch.state.previous;
    metric_.set_load_scale(branch.load_scale);
    tangent_ = {branch.side * branch.shape, 0.0};
    sense_ = 0;
    pivots_ = -1;
    system_.compute_residual(state_, state_.time, workspace_.residual);
    accept_start(state_.time, true);
    sequence().start(branch.first_step);
    return {};
}

EquilibriumReport PathAnalysis::solve_trial() {
    trial_point_.reset();
    trial_branches_.clear();
    trial_ = {};
    trial_.step = steps_->time_step();
    if (branch_) return solve_branch_trial();
    PathContext search = work();
    return solve_path_step(search, trial_.step * tangent_, metric_.row(tangent_), trial_);
}

EquilibriumReport PathAnalysis::solve_branch_trial() {
    PathContext search = work();
    EquilibriumReport report;
    const std::optional<PathTrial> found = step_on_branch(search, *branch_, steps_->time_step());
    report.iterations = search.iterations;
    if (!found) {
        report.outcome = Outcome::out_of_iterations;
        return report;
    }
    trial_ = *found;
    report.negative_pivots = trial_.pivots;
    report.residual = trial_.residual;
    sequence().end_at(trial_.step);
    return report;
}

void PathAnalysis::judge_equilibrium(EquilibriumReport& report) {
    const double cosine = metric_.multiply(trial_.direction, tangent_);
    const bool can_shorten = !sequence().is_shortest();
    if (!branch_ && can_shorten && cosine < std::cos(widest_angle)) {
        report.outcome = Outcome::lost_stability;
        return;
    }
    PathContext search = work();
    const double whole = trial_.step;
    if (!branch_ && !targets_.hit(search, trial_)) {
        report.outcome = Outcome::lost_stability;
        return;
    }
    if (trial_.step != whole) sequence().end_at(trial_.step);
    report.negative_pivots = trial_.pivots;
    trial_sense_ = sign_of(trial_.direction.load);
    count_pivots(report);
    sequence().adapt(report.iterations);
    if (!look_for_critical_points()) report.outcome = Outcome::lost_stability;
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
    if (!changes && report.iterations > few) return;
    // The last iteration's tangent was that of the iterate before.
    const std::optional<PathTangent> exact = compute_path_tangent(
        system_, *integrator_, metric_, trial_.direction, trial_.load_factor, workspace_, state_);
    if (!exact) return;
    trial_.direction = exact->direction;
    trial_sense_ = sign_of(trial_.direction.load);
    trial_.pivots = exact->negative_pivots;
    if (trial_.pivots < 0)
        trial_.pivots =
            counter_.count(*integrator_, {0, state_.time, 0.0, trial_.load_factor}, workspace_, state_);
}

bool PathAnalysis::look_for_critical_points() {
    if (settings_.critical == CriticalSearch::off || sense_ == 0) return true;
    const bool turns = trial_sense_ != sense_;
    const std::int64_t change = pivots_ < 0 || trial_.pivots < 0 ? 0 : trial_.pivots - pivots_;
    if (!turns && change == 0) return true;
    if (settings_.critical == CriticalSearch::locate) {
        const PathTrial end = trial_;
        if (keep(locate(turns, change))) return true;
        if (!sequence().is_short()) return false;
        // Back to where the step ended.
        PathContext search = exact_work();
        if (!solve_path_step(search, end.step * tangent_, metric_.row(tangent_), trial_).converged())
            return false;
        trial_ = end;
    }
    keep_unlocated(turns ? CriticalKind::limit : crossing_kind(),
                   std::max(1, static_cast<int>(std::abs(change))));
    return true;
}

// At a limit point both change, by one; elsewhere, if that is not several points in one step, the path
// crosses another one.
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
    if (!located->turns && located->multiplicity == 1) find_branches(*located);
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
    trial_point_ = std::move(point);
}

void PathAnalysis::describe(CriticalPoint& point, const Eigen::MatrixXd& kernel) {
    for (Eigen::Index i = 0; i < kernel.cols(); ++i) {
        std::vector<Vec6> shape(state_.trial.size());
        for (std::size_t node = 0; node < shape.size(); ++node)
            shape[node] = system_.equations().increment_of(static_cast<int>(node), kernel.col(i));
        point.kernel.push_back(std::move(shape));
    }
    compute_consistent_tangent(system_, *integrator_, point.load_factor, workspace_, state_);
    const std::optional<Weakness> weakness = describe_weakness(system_, state_, workspace_.values);
    if (weakness) point.shape = weakness->words;
}

// The state at the bifurcation is used up by trials of both sides, and so is a copy.
void PathAnalysis::find_branches(const LocatedPoint& located) {
    State at = state_;
    system_.commit(at, located.trial.load_factor);
    std::array<double, 2> rises{};
    for (const int side : {1, -1}) {
        BranchStart start{at,
                          metric_.load_scale(),
                          located.trial.direction,
                          located.kernel.col(0),
                          located.softening,
                          points_.size(),
                          side,
                          0.0};
        for (double step = 0.1 * settings_.max_step; step > settings_.min_step; step *= 0.25) {
            State trial = at;
            PathContext search{system_, *integrator_, newton_, metric_, has_potential_, workspace_, trial};
            const std::optional<PathTrial> found = step_on_branch(search, start, step);
            if (!found ||
                metric_.multiply(found->direction, {side * start.shape, 0.0}) < std::cos(widest_angle))
                continue;
            start.first_step = step;
            rises[side > 0 ? 0 : 1] = found->load_factor - at.time;
            trial_branches_.push_back(std::move(start));
            break;
        }
    }
    system_.compute_residual(state_, located.trial.load_factor, workspace_.residual);
    if (trial_branches_.size() < 2) return;
    const bool is_pitchfork = (rises[0] > 0.0) == (rises[1] > 0.0);
    const bool gets_unstable = located.trial.pivots > pivots_;
    const bool goes_with_path = (rises[0] > 0.0) == (located.trial.direction.load > 0.0);
    trial_point_->branching = !is_pitchfork                     ? Branching::transcritical
                              : gets_unstable == goes_with_path ? Branching::supercritical
                                                                : Branching::subcritical;
}

// A loop begins and ends at the same bifurcation.
bool PathAnalysis::is_closed() const {
    constexpr double close = 1e-5;
    if (origin_.empty() || points_.empty() || points_.back().step != steps_->steps_done() + 1) return false;
    double farthest = 0.0;
    for (std::size_t i = 0; i < origin_.size(); ++i)
        farthest = std::max(farthest, (origin_[i].r - state_.trial[i].r).norm());
    return farthest < close * system_.length_scale();
}

void PathAnalysis::note_equilibrium() {
    tangent_ = trial_.direction;
    pivots_ = trial_.pivots;
    sense_ = trial_sense_;
    branch_.reset();
    if (trial_point_) {
        trial_point_->step = steps_->steps_done() + 1;
        trial_point_->arc_length = steps_->next_time();
        points_.push_back(std::move(*trial_point_));
        trial_point_.reset();
        for (BranchStart& start : trial_branches_) branches_.push_back(std::move(start));
        trial_branches_.clear();
    }
    const auto count = points_before_ + static_cast<std::int64_t>(points_.size());
    if (targets_.is_end(trial_.load_factor) || is_closed() ||
        (settings_.points && count >= *settings_.points))
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
    memory.points = points_before_ + static_cast<std::int64_t>(points_.size());
}

void PathAnalysis::recall(const RestartRecord& record) {
    const PathMemory& memory = record.path;
    state_.time = memory.load_factor;
    metric_.set_load_scale(memory.load_scale);
    tangent_ = {gather(memory.tangent, system_.equations()), memory.load_rate};
    sense_ = static_cast<int>(memory.load_sense);
    points_before_ = memory.points;
}

}  // namespace gxrod
