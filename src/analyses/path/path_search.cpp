#include "analyses/path/path_search.hpp"

#include "analyses/path/limit_search.hpp"
#include "assembly/contact/contacts.hpp"
#include "solvers/newton_steps.hpp"
#include "state/increment.hpp"

namespace gxrod {

EquilibriumReport solve_path_step(PathContext& work,
                                  const PathVector& prediction,
                                  const PathVector& row,
                                  PathTrial& trial) {
    if (work.limit_load_factor != nullptr) return solve_limit_step(work, prediction, row, trial);
    PathSolution solution;
    const EquilibriumReport report = solve_path_equilibrium({work.system, work.integrator, work.newton},
                                                            {prediction, {row}, {}, nullptr},
                                                            work.workspace,
                                                            work.state,
                                                            solution);
    work.iterations += report.iterations;
    if (!report.converged()) return report;
    trial.load_factor = solution.load_factor;
    trial.pivots = report.negative_pivots;
    trial.residual = report.residual;
    trial.effort = report.iterations;
    const double length = work.metric.norm(solution.direction);
    const double sense = work.metric.multiply(solution.direction, prediction) < 0.0 ? -1.0 : 1.0;
    trial.direction = (sense / length) * solution.direction;
    return report;
}

bool solve_exact_step(PathContext& work, const PathVector& direction, double step, PathTrial& trial) {
    const PathVector row = work.metric.row(direction);
    if (!solve_path_step(work, step * direction, row, trial).converged()) return false;
    const std::optional<PathTangent> tangent = compute_path_tangent(
        work.system, work.integrator, work.metric, direction, trial.load_factor, work.workspace, work.state);
    if (!tangent) return false;
    trial.step = step;
    trial.direction = tangent->direction;
    trial.pivots = tangent->negative_pivots;
    return true;
}

bool place_trial(PathContext& work, const std::vector<Vec6>& movement, double load_factor) {
    State& state = work.state;
    for (std::size_t i = 0; i < movement.size(); ++i) {
        const NodeMotion& from = state.previous[i];
        place(from, from.r + movement[i].head<3>(), movement[i].tail<3>(), state.trial[i]);
    }
    work.system.supports().place(load_factor, state);
    const Contacts contacts(work.system);
    if (contacts.are_possible()) {
        state.contact = {};
        contacts.search(state);
        if (!(contacts.count(state, load_factor).least_gap > 0.0)) return false;
    }
    work.system.compute_residual(state, load_factor, work.workspace.residual);
    return true;
}

}  // namespace gxrod
