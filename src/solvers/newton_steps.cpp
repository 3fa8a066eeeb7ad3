#include "solvers/newton_steps.hpp"

#include "solvers/paired_matrix.hpp"

#include <algorithm>
#include <cmath>

namespace gxrod {

namespace {

struct Worst {
    double residual = 0.0;
    int node = -1;
    int component = -1;
};

// The first that is not finite, or else the largest, of nodes first … last − 1.
Worst find_worst(const System& system,
                 const Residual& residual,
                 const NodeScales& scales,
                 std::size_t first,
                 std::size_t last) {
    const Supports& supports = system.supports();
    Worst worst;
    for (int node = static_cast<int>(first); node < static_cast<int>(last); ++node) {
        const Vec6 own = supports.has_own_axes(node)
                             ? system.equations().to_own_axes(node, residual.nodal[node])
                             : residual.nodal[node];
        const ResidualScales& scale = scales.of(node);
        if ((own.head<3>().array().abs() <= worst.residual * scale.force).all() &&
            (own.tail<3>().array().abs() <= worst.residual * scale.moment).all())
            continue;
        const HeldComponents& held = supports.held(node);
        for (int component = 0; component < 6; ++component) {
            const double value = std::abs(own[component]);
            if (value == 0.0 || held[component]) continue;
            const double scaled = value / scale.of(component);
            if (!std::isfinite(scaled)) return {scaled, node, component};
            if (scaled > worst.residual) worst = {scaled, node, component};
        }
    }
    return worst;
}

}  // namespace

void measure_residual(const System& system, const Residual& residual, EquilibriumReport& report) {
    const NodeScales scales = system.scale_groups().compute_scales(residual);
    const std::vector<Worst> parts =
        system.team().collect<Worst>(residual.nodal.size(), [&](std::size_t first, std::size_t last) {
            return find_worst(system, residual, scales, first, last);
        });
    Worst worst;
    for (const Worst& part : parts) {
        if (part.residual > worst.residual || !std::isfinite(part.residual)) worst = part;
        if (!std::isfinite(worst.residual)) break;
    }
    report.residual = worst.residual;
    if (worst.node < 0) return;
    report.worst_node = worst.node;
    report.worst_component = worst.component;
    if (!std::isfinite(worst.residual)) report.outcome = Outcome::not_finite;
}

bool is_as_large_as_forces(const System& system, const Residual& residual, const EquilibriumReport& report) {
    constexpr double tenth = 0.1;
    const ScaleGroups& groups = system.scale_groups();
    const double length = system.scale_groups().length_at(report.worst_node);
    const double worst =
        report.residual * groups.compute_scales(residual).of(report.worst_node).of(report.worst_component);
    const double force = report.worst_component < 3 ? worst : worst / length;
    const ForceScales acting = groups.acting_in(groups.of_node(report.worst_node), residual);
    return force > tenth * std::max(acting.force_scale, acting.moment_scale / length);
}

Eigen::VectorXd gather_residual(const System& system,
                                const Residual& residual,
                                const std::vector<double>& values) {
    Eigen::VectorXd vector = gather(residual.nodal, system.equations(), system.team());
    if (!system.joints().empty()) system.joints().set_rows(residual.rows, values, vector);
    return vector;
}

double largest_component(const System& system, const Residual& residual) {
    return gather(residual.nodal, system.equations(), system.team()).lpNorm<Eigen::Infinity>();
}

bool solve_increment(const System& system,
                     const Eigen::VectorXd& residual,
                     SolverWorkspace& workspace,
                     EquilibriumReport& report) {
    const PhaseTimer timer(workspace.seconds.solve);
    workspace.vector = -residual;
    if (workspace.is_paired) {
        workspace.paired->solve(workspace.vector);
    } else {
        workspace.linear_solver->solve(workspace.vector);
    }
    if (workspace.vector.allFinite()) return true;
    std::int64_t i = 0;
    while (std::isfinite(workspace.vector[i])) ++i;
    report.outcome = Outcome::not_finite;
    report.worst_node = system.equations().unknown(i).node;
    report.worst_component = system.equations().unknown(i).component;
    return false;
}

ConstraintRequest find_request(const System& system, const Integrator& integrator, const Stage& stage) {
    const ConstraintLevel level =
        system.joints().are_linear() ? ConstraintLevel::position : integrator.constraint_level(stage.index);
    ConstraintRequest request{level, {stage.step_time, stage.time_step}};
    request.contact_weight = integrator.contact_weight();
    return request;
}

void add_accelerations(const System& system, SolverWorkspace& workspace, State& state) {
    std::vector<Vec6>& increments = workspace.increments;
    increments.resize(state.trial.size());
    for (std::size_t node = 0; node < increments.size(); ++node) {
        increments[node] = system.equations().increment_of(static_cast<int>(node), workspace.vector);
        state.trial[node].a += increments[node].head<3>();
        state.trial[node].alpha += increments[node].tail<3>();
    }
    system.joints().advance_multipliers(increments, workspace.vector, workspace.values, state);
}

int count_corrections(const System& system) {
    if (system.joints().empty()) return 0;
    return system.joints().have_friction_by_multipliers() ? 12 : 2;
}

bool factorize(const System& system, SolverWorkspace& workspace, EquilibriumReport& report) {
    const PhaseTimer timer(workspace.seconds.solve);
    const Factorization factorization = workspace.is_paired
                                            ? workspace.paired->factorize()
                                            : workspace.linear_solver->factorize(workspace.values);
    // Each multiplier adds one.
    report.negative_pivots = factorization.negative_pivots;
    if (report.negative_pivots >= 0) report.negative_pivots -= system.equations().attached_count();
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
