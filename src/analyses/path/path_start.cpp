// How a path begins.
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "analyses/path/limit_search.hpp"
#include "analyses/path/path.hpp"
#include "solvers/newton_steps.hpp"

namespace gxrod {

namespace {

// The first step moves the model by so much, and the load factor by this part of its range.
constexpr double first_movement = 0.05;
constexpr double first_part = 0.1;

}  // namespace

EquilibriumReport PathAnalysis::start() {
    for (NodeMotion& motion : state_.trial) {
        motion.v.setZero();
        motion.omega.setZero();
        motion.a.setZero();
        motion.alpha.setZero();
    }
    state_.previous = state_.trial;
    if (settings_.limit_load_factor) return start_at_limit();
    // What acts at t = 0 already acts before the path begins.
    EquilibriumReport report =
        solve_equilibrium({system_, *integrator_, newton_}, {0, 0.0, 0.0, 0.0}, workspace_, state_);
    if (!report.converged()) return report;
    const bool is_loaded = report.iterations > 0;
    accept_start(0.0, is_loaded);
    return find_first_direction();
}

EquilibriumReport PathAnalysis::start_at_limit() {
    const auto no_limit = [] {
        return std::runtime_error(
            "the stage before does not end at a limit point that could be followed; a path ends there by "
            "until = { points = … }");
    };
    constexpr double near = 0.01;  // of arc length: how far from the limit point the stage before may end
    state_.time = 0.0;
    PathContext search = exact_work();
    const PathVector none{Eigen::VectorXd::Zero(system_.equations().count()), 0.0};
    EquilibriumReport report = solve_limit_step(search, none, {none.u, 1.0}, trial_);
    const bool is_found = report.converged() && trial_.step <= near;
    if (!is_found) {
        undo_trial(state_);
        restore_limit_load();
        system_.compute_residual(state_, 0.0, workspace_.residual);
    }
    limit_load_factor_ = *settings_.limit_load_factor;
    tangent_ = {none.u, 1.0};
    accept_start(0.0, true);
    if (!is_found) throw no_limit();
    const std::optional<Eigen::VectorXd> rate = find_limit_rate(search);
    if (!rate) throw no_limit();
    set_first_direction(*rate);
    pivots_ = -1;
    return report;
}

bool PathAnalysis::falls_first(const Eigen::VectorXd& rate) const {
    if (!control_ || !settings_.control->to) return settings_.least_load && !settings_.greatest_load;
    const double way = *settings_.control->to - targets_.value_of(*settings_.control, state_.previous);
    return way * control_->u.dot(rate) < 0.0;
}

void PathAnalysis::set_first_direction(const Eigen::VectorXd& rate) {
    metric_.scale_load(rate);
    const bool falls = falls_first(rate);
    tangent_ = {rate, 1.0};
    tangent_ = ((falls ? -1.0 : 1.0) / metric_.norm(tangent_)) * tangent_;
    sense_ = falls ? -1 : 1;
    const double range = std::max(std::abs(settings_.greatest_load.value_or(falls ? 0.0 : 1.0)),
                                  std::abs(settings_.least_load.value_or(0.0)));
    sequence().start(
        std::min(first_movement * std::numbers::sqrt2, first_part * range / std::abs(tangent_.load)));
}

EquilibriumReport PathAnalysis::find_first_direction() {
    EquilibriumReport report;
    compute_consistent_tangent(system_, *integrator_, state_.time, workspace_, state_);
    if (!factorize(system_, workspace_, report)) return report;
    Eigen::VectorXd rate = -compute_load_gradient(system_, state_.time, workspace_.values, state_);
    factorized_tangent(system_, workspace_).solver.solve(rate);
    if (!rate.allFinite()) {
        report.outcome = Outcome::not_finite;
        return report;
    }
    set_first_direction(rate);
    pivots_ = has_pivots_
                  ? counter_.count(*integrator_, {0, state_.time, 0.0, state_.time}, workspace_, state_)
                  : -1;
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

}  // namespace gxrod
