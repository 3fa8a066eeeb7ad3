#include "analyses/start_velocities.hpp"

#include <fmt/format.h>

#include "model/evaluation_error.hpp"
#include "rotation/vector_text.hpp"
#include "solvers/hidden_constraints.hpp"
#include "solvers/newton_steps.hpp"

namespace gxrod {

namespace {

constexpr double same_velocity = 1e-8;  // relative to the largest
// Of a step: a span for rates of moves in which what differences leave out is round-off.
constexpr double part_of_step = 1e-2;

std::string describe(const Vec3& v) {
    // Round-off of a projection is not worth a digit.
    return in_brackets(v, 9, 1e-12 * v.norm());
}

[[noreturn]] void report(const System& system, int index, const State& state, const State& fitting) {
    const int node = system.joints().shown_node(index);
    const NodeMotion& fits = fitting.trial[static_cast<std::size_t>(node)];
    throw EvaluationError(
        fmt::format("the initial velocities do not fit {}; nearest to all that are given, those that "
                    "fit have velocity = {} "
                    "and angular_velocity = {} at {} (given: {} and {}). Give such velocities, or start = "
                    "\"project\" in the "
                    "analysis to take the nearest ones",
                    system.joints().name(index),
                    describe(fits.v),
                    describe(fits.omega),
                    system.model().nodes[static_cast<std::size_t>(node)].name,
                    describe(state.trial[static_cast<std::size_t>(node)].v),
                    describe(state.trial[static_cast<std::size_t>(node)].omega)));
}

// Equations of joints for velocities at a time, of motions whose moved supports have their rates there.
std::vector<double> compute_rows(
    const System& system, const State& state, double time, const TimeSpan& span, double time_scale) {
    State moving = state;
    system.supports().set_rates(time, span, moving.trial);
    std::vector<double> rows;
    system.joints().compute_rows(moving, time, {ConstraintLevel::velocity, span, time_scale}, rows);
    return rows;
}

}  // namespace

double measure_rate_jump(
    const System& before, const State& at_end, const System& after, const State& at_start, double step) {
    if (after.joints().empty()) return 0.0;
    const double span = part_of_step * step;
    State moving = at_start;
    after.supports().set_rates(0.0, {0.0, span}, moving.trial);
    const double time_scale = find_time_scale(after, moving);
    std::vector<double> rows = compute_rows(after, at_start, 0.0, {0.0, span}, time_scale);
    if (before.model().has_time) {
        const std::vector<double> ended =
            compute_rows(before, at_end, at_end.time, {at_end.time - span, span}, time_scale);
        for (std::size_t i = 0; i < std::min(rows.size(), ended.size()); ++i) rows[i] -= ended[i];
    }
    return after.joints().measure_gap(rows, moving).size;
}

void fit_start_velocities(const System& system,
                          double time,
                          const TimeSpan& step,
                          bool projects,
                          SolverWorkspace& workspace,
                          State& state) {
    const JointAssembly& joints = system.joints();
    if (joints.empty()) return;
    // Motors and moved supports may start with a rate.
    State fitting = state;
    system.supports().set_rates(time, step, fitting.trial);
    const double time_scale = find_time_scale(system, fitting);
    const auto measure = [&](const TimeSpan& span) {
        return joints.measure_gap(compute_rows(system, state, time, span, time_scale), fitting);
    };
    const LargestGap gap = measure(step);
    if (gap.size <= same_velocity) return;
    if (measure({step.start, part_of_step * step.length}).size <= same_velocity) projects = true;
    // Leaves the mass matrix factorized.
    EquilibriumReport solved = solve_accelerations(system, time, step, workspace, fitting);
    if (!solved.converged()) return;  // the start fails on it, and reports why
    project_velocities(system, time, step, workspace, fitting, solved);
    if (!projects || !solved.converged()) report(system, gap.joint, state, fitting);
    for (std::size_t i = 0; i < state.trial.size(); ++i) {
        state.trial[i].v = fitting.trial[i].v;
        state.trial[i].omega = fitting.trial[i].omega;
    }
}

}  // namespace gxrod
