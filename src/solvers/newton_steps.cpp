#include "solvers/newton_steps.hpp"

#include <algorithm>
#include <cmath>

namespace gxrod {

ResidualScales compute_scales(const System& system, const Residual& residual) {
    const double length = system.length_scale();
    return {std::max(residual.force_scale, 1e-6 * residual.moment_scale / length),
            std::max(residual.moment_scale, 1e-6 * residual.force_scale * length)};
}

void measure_residual(const System& system, const Residual& residual, EquilibriumReport& report) {
    const ResidualScales scales = compute_scales(system, residual);
    const EquationNumbers& equations = system.equations();
    report.residual = 0.0;
    for (int node = 0; node < static_cast<int>(residual.nodal.size()); ++node) {
        const Vec6 own = equations.to_own_axes(node, residual.nodal[node]);
        const std::array<std::int64_t, 6> numbers = equations.of_node(node);
        for (int component = 0; component < 6; ++component) {
            const double value = std::abs(own[component]);
            if (numbers[component] < 0 || value == 0.0) continue;
            const double scaled = value / scales.of(component);
            if (std::isfinite(scaled) && scaled <= report.residual) continue;
            report.residual = scaled;
            report.worst_node = node;
            report.worst_component = component;
            if (std::isfinite(scaled)) continue;
            report.outcome = Outcome::not_finite;
            return;
        }
    }
}

double largest_component(const System& system, const Residual& residual) {
    return gather(residual.nodal, system.equations()).lpNorm<Eigen::Infinity>();
}

bool solve_increment(const System& system,
                     const Eigen::VectorXd& residual,
                     SolverWorkspace& workspace,
                     EquilibriumReport& report) {
    const PhaseTimer timer(workspace.seconds.solve);
    workspace.vector = -residual;
    workspace.linear_solver->solve(workspace.vector);
    for (std::int64_t i = 0; i < workspace.vector.size(); ++i) {
        if (std::isfinite(workspace.vector[i])) continue;
        report.outcome = Outcome::not_finite;
        report.worst_node = system.equations().unknown(i).node;
        report.worst_component = system.equations().unknown(i).component;
        return false;
    }
    return true;
}

bool factorize(const System& system, SolverWorkspace& workspace, EquilibriumReport& report) {
    const PhaseTimer timer(workspace.seconds.solve);
    const Factorization factorization = workspace.linear_solver->factorize(workspace.values);
    if (factorization.regular) return true;
    report.outcome = Outcome::singular;
    report.worst_node = report.worst_component = -1;
    if (factorization.singular_equation >= 0) {
        report.worst_node = system.equations().unknown(factorization.singular_equation).node;
        report.worst_component = system.equations().unknown(factorization.singular_equation).component;
    }
    return false;
}

}  // namespace gxrod
