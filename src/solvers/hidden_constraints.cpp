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

// The equations that trial motions are to meet, and what is tolerated where all corrections leave it.
struct Goal {
    double time;
    ConstraintRequest request;
    double most;
};

// Calls correct(trial, previous, increment) for each node until the equations are met or are no longer met
// better. Returns the sum of the increments.
template <class Correct>
Eigen::VectorXd project(const System& system,
                        const Goal& goal,
                        SolverWorkspace& workspace,
                        State& state,
                        EquilibriumReport& report,
                        const Correct& correct) {
    const JointAssembly& joints = system.joints();
    workspace.increments.resize(state.trial.size());
    Eigen::VectorXd total = Eigen::VectorXd::Zero(system.equations().count());
    std::vector<double>& rows = workspace.residual.rows;
    double before = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= most_corrections; ++i) {
        joints.compute_rows(state, goal.time, goal.request, rows);
        report.joint_gap = joints.measure_gap(rows, state);
        const double gap = report.joint_gap.size;
        if (gap <= met || (gap <= tolerable && gap >= 0.5 * before)) return total;
        if (i == most_corrections && gap <= goal.most) return total;
        if (i == most_corrections || !(gap < 1e3 * before)) break;
        before = gap;
        // Of rods that touch, the steps have factorized another matrix, with pairs.
        if (i == 0 && workspace.paired && !factorize(system, workspace, report)) return total;
        Eigen::VectorXd residual = Eigen::VectorXd::Zero(system.equations().count());
        joints.set_rows(rows, workspace.values, residual);
        if (!solve_increment(system, residual, workspace, report)) return total;
        total += workspace.vector;
        for (std::size_t node = 0; node < workspace.increments.size(); ++node)
            correct(state.trial[node],
                    state.previous[node],
                    system.equations().increment_of(static_cast<int>(node), workspace.vector));
    }
    report.outcome = Outcome::joints_open;
    return total;
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

Eigen::VectorXd project_velocities(const System& system,
                                   double time,
                                   const TimeSpan& step,
                                   SolverWorkspace& workspace,
                                   State& state,
                                   EquilibriumReport& report) {
    const double time_scale = find_time_scale(system, state);
    const Goal goal{time, {ConstraintLevel::velocity, step, time_scale}, tolerable_in_line};
    return project(system,
                   goal,
                   workspace,
                   state,
                   report,
                   [&](NodeMotion& trial, const NodeMotion& /*previous*/, const Vec6& increment) {
                       trial.v += increment.head<3>() / time_scale;
                       trial.omega += increment.tail<3>() / time_scale;
                   });
}

Eigen::VectorXd project_positions(
    const System& system, double time, SolverWorkspace& workspace, State& state, EquilibriumReport& report) {
    const Goal goal{time, {.stops = StopChoice::at_end}, tolerable};
    return project(system,
                   goal,
                   workspace,
                   state,
                   report,
                   [](NodeMotion& trial, const NodeMotion& previous, const Vec6& increment) {
                       apply_spin(previous, increment.head<3>(), increment.tail<3>(), trial);
                   });
}

}  // namespace gxrod
