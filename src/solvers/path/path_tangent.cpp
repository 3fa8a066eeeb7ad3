#include "solvers/path/path_tangent.hpp"

#include "assembly/contact/contacts.hpp"
#include "solvers/newton_steps.hpp"
#include "solvers/paired_matrix.hpp"
#include "solvers/path/bordered_solve.hpp"
#include "solvers/path/path_newton.hpp"

namespace gxrod {

FactorizedTangent factorized_tangent(const System& system, SolverWorkspace& workspace) {
    if (workspace.is_paired)
        return {workspace.paired->solver(), workspace.paired->pattern(), workspace.paired->values()};
    return {*workspace.linear_solver, system.pattern(), workspace.values};
}

void compute_tangent_on_path(const System& system,
                             double load_factor,
                             const State& state,
                             SolverWorkspace& workspace) {
    system.compute_tangent(state, load_factor, workspace.linearizations, workspace.values);
    if (!workspace.paired) return;
    workspace.is_paired = true;
    workspace.paired->set_values(workspace.values,
                                 Contacts(system).compute_tangents(state, 1.0, workspace.linearizations));
}

void compute_consistent_tangent(const System& system,
                                const Integrator& integrator,
                                double load_factor,
                                SolverWorkspace& workspace,
                                State& state) {
    std::vector<Vec6> resultants;
    resultants.swap(state.resultants);
    const Stage stage{0, state.time, 0.0, load_factor};
    integrator.linearize(state, stage, workspace.linearizations, system.team());
    compute_tangent_on_path(system, load_factor, state, workspace);
    resultants.swap(state.resultants);
}

std::optional<PathTangent> compute_path_tangent(const System& system,
                                                const Integrator& integrator,
                                                const PathMetric& metric,
                                                const PathVector& along,
                                                double load_factor,
                                                SolverWorkspace& workspace,
                                                State& state) {
    compute_consistent_tangent(system, integrator, load_factor, workspace, state);
    EquilibriumReport report;
    if (!factorize(system, workspace, report)) return std::nullopt;
    const PathVector row = metric.row(along);
    const FactorizedTangent tangent = factorized_tangent(system, workspace);
    const BorderedSolve bordered(tangent.solver,
                                 tangent.pattern,
                                 tangent.values,
                                 {compute_load_gradient(system, load_factor, workspace.values, state),
                                  row.u,
                                  Eigen::MatrixXd::Constant(1, 1, row.load)});
    const BorderedVector solved =
        bordered.solve_refined({Eigen::VectorXd::Zero(row.u.size()), Eigen::VectorXd::Ones(1)});
    PathVector direction{solved.x, solved.y[0]};
    const double length = metric.norm(direction);
    if (!std::isfinite(length) || length == 0.0) return std::nullopt;
    return PathTangent{(1.0 / length) * direction, report.negative_pivots};
}

}  // namespace gxrod
