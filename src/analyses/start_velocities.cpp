#include "analyses/start_velocities.hpp"

#include <fmt/format.h>

#include "model/evaluation_error.hpp"
#include "solvers/hidden_constraints.hpp"
#include "solvers/newton_steps.hpp"

namespace gxrod {

namespace {

constexpr double same_velocity = 1e-8;  // relative to the largest

std::string describe(const Vec3& v) {
    // Round-off of a projection is not worth a digit.
    const auto clean = [&](double x) { return std::abs(x) < 1e-12 * v.norm() ? 0.0 : x; };
    return fmt::format("[{:.9g}, {:.9g}, {:.9g}]", clean(v.x()), clean(v.y()), clean(v.z()));
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

}  // namespace

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
    std::vector<double> rows;
    joints.compute_rows(
        fitting, time, {ConstraintLevel::velocity, step, find_time_scale(system, fitting)}, rows);
    const LargestGap gap = joints.measure_gap(rows, fitting);
    if (gap.size <= same_velocity) return;
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
