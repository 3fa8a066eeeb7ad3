#include "solvers/hidden_constraints.hpp"

#include <algorithm>

#include "solvers/newton_steps.hpp"
#include "state/increment.hpp"

namespace gxrod {

namespace {

constexpr double met = 1e-12;       // of the scale
constexpr double tolerable = 1e-8;  // where round-off leaves more
constexpr int most_corrections = 8;
// The regularization of the joints' equations truncates their factorization: a correction takes the part
// ε/(σ² + ε) of the gap away, σ the singular value by which velocities change it, and so after all
// corrections what is left has σ below some √ε. These are the equations that lose their rank where bars come
// into line; velocities cannot meet them, and positions do, in the steps that follow.
constexpr double tolerable_in_line = 1e-6;

// Calls correct(increments of the nodes) until measure(rows) is small or no longer falls. `most` is tolerated
// where all corrections leave it.
template <class Compute, class Measure, class Correct>
void project(const System& system,
             SolverWorkspace& workspace,
             EquilibriumReport& report,
             Eigen::VectorXd* total,
             double most,
             const Compute& compute_rows,
             const Measure& measure,
             const Correct& correct) {
    if (total) *total = Eigen::VectorXd::Zero(system.equations().count());
    std::vector<double>& rows = workspace.residual.rows;
    double before = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= most_corrections; ++i) {
        compute_rows(rows);
        report.joint_gap = measure(rows);
        const double gap = report.joint_gap.size;
        if (gap <= met || (gap <= tolerable && gap >= 0.5 * before)) return;
        if (i == most_corrections && gap <= most) return;
        if (i == most_corrections || !(gap < 1e3 * before)) break;
        before = gap;
        // Of rods that touch, the steps have factorized another matrix, with pairs.
        if (i == 0 && workspace.paired && !factorize(system, workspace, report)) return;
        Eigen::VectorXd residual = Eigen::VectorXd::Zero(system.equations().count());
        system.joints().set_rows(rows, workspace.values, residual);
        if (!solve_increment(system, residual, workspace, report)) return;
        if (total) *total += workspace.vector;
        for (std::size_t node = 0; node < workspace.increments.size(); ++node)
            correct(node, system.equations().increment_of(static_cast<int>(node), workspace.vector));
    }
    report.outcome = Outcome::joints_open;
}

}  // namespace

bool has_hidden_constraints(const System& system) {
    return !system.joints().are_linear() && system.model().has_inertia;
}

double find_time_scale(const System& system, const State& state) {
    double speed = 0.0;
    for (const NodeMotion& trial : state.trial)
        speed = std::max({speed, trial.v.norm(), trial.omega.norm() * system.length_scale()});
    return speed > 0.0 ? system.length_scale() / speed : 1.0;
}

void project_velocities(const System& system,
                        double time,
                        const TimeSpan& step,
                        SolverWorkspace& workspace,
                        State& state,
                        EquilibriumReport& report,
                        Eigen::VectorXd* total) {
    const JointAssembly& joints = system.joints();
    workspace.increments.resize(state.trial.size());
    const double time_scale = find_time_scale(system, state);
    project(
        system,
        workspace,
        report,
        total,
        tolerable_in_line,
        [&](std::vector<double>& rows) {
            joints.compute_rows(state, time, {ConstraintLevel::velocity, step, time_scale}, rows);
        },
        [&](const std::vector<double>& rows) { return joints.measure_gap(rows, state); },
        [&](std::size_t node, const Vec6& increment) {
            state.trial[node].v += increment.head<3>() / time_scale;
            state.trial[node].omega += increment.tail<3>() / time_scale;
        });
}

void project_positions(const System& system,
                       double time,
                       SolverWorkspace& workspace,
                       State& state,
                       EquilibriumReport& report,
                       Eigen::VectorXd* total) {
    const JointAssembly& joints = system.joints();
    workspace.increments.resize(state.trial.size());
    project(
        system,
        workspace,
        report,
        total,
        tolerable,
        [&](std::vector<double>& rows) {
            joints.compute_rows(state, time, {.stops = StopChoice::at_end}, rows);
        },
        [&](const std::vector<double>& rows) { return joints.measure_gap(rows, state); },
        [&](std::size_t node, const Vec6& increment) {
            apply_spin(state.previous[node], increment.head<3>(), increment.tail<3>(), state.trial[node]);
        });
}

}  // namespace gxrod
