#include "solvers/difference_tangent.hpp"

#include "solvers/trial_rates.hpp"
#include "state/increment.hpp"

namespace gxrod {

namespace {

constexpr double step_angle = 1e-6;  // rad; lengths are this times the model's length

void move(const System& system,
          const Integrator& integrator,
          const Stage& stage,
          const std::vector<std::int64_t>& group,
          double sign,
          State& state) {
    for (const std::int64_t equation : group) {
        const EquationNumbers::Unknown unknown = system.equations().unknown(equation);
        if (unknown.attached >= 0) continue;
        const int node = unknown.node;
        const int component = unknown.component;
        const double size = component < 3 ? step_angle * system.length_scale() : step_angle;
        const Vec6 delta = system.equations().to_global_axes(node, sign * size * Vec6::Unit(component));
        apply_spin(state.previous[node], delta.head<3>(), delta.tail<3>(), state.trial[node]);
    }
    update_trial_rates(system, integrator, stage, state);
}

// The differences have found how the forces of multipliers turn.
void add_joint_rows(const System& system,
                    const Integrator& integrator,
                    const Stage& stage,
                    const ConstraintRequest& request,
                    const State& state,
                    std::vector<double>& values) {
    if (system.joints().empty()) return;
    State without_forces = state;
    for (JointState& joint : without_forces.joints_trial) joint.multipliers.fill(0.0);
    std::vector<NodeLinearization> linearizations;
    integrator.linearize(state, stage, linearizations, system.team());
    system.joints().add_tangents(
        without_forces, integrator.stage_time(stage), request, linearizations, values);
}

}  // namespace

std::vector<std::vector<std::int64_t>> group_columns(const SparsePattern& pattern) {
    std::vector<std::vector<std::int64_t>> groups;
    std::vector<std::int64_t>
        last_column_with_row;  // per group and row, the latest member that touches the row
    const std::int64_t size = pattern.size();
    for (std::int64_t column = 0; column < size; ++column) {
        const auto touches = [&](std::size_t group) {
            bool found = false;
            pattern.visit_column(column, [&](std::int64_t row, std::int64_t) {
                found = found || last_column_with_row[group * size + row] >= 0;
            });
            return found;
        };
        std::size_t group = 0;
        while (group < groups.size() && touches(group)) ++group;
        if (group == groups.size()) {
            groups.emplace_back();
            last_column_with_row.resize(groups.size() * size, -1);
        }
        groups[group].push_back(column);
        pattern.visit_column(column, [&](std::int64_t row, std::int64_t) {
            last_column_with_row[group * size + row] = column;
        });
    }
    return groups;
}

DifferenceTangent::DifferenceTangent(const System& system)
    : system_(&system), groups_(group_columns(system.pattern())) {}

void DifferenceTangent::compute(const Integrator& integrator,
                                const Stage& stage,
                                State& state,
                                std::vector<double>& values,
                                const ConstraintRequest& request) {
    const SparsePattern& pattern = system_->pattern();
    const double time = integrator.stage_time(stage);
    const ConstraintRequest forces{.contact_weight = request.contact_weight};
    values.assign(static_cast<std::size_t>(pattern.nonzeros()), 0.0);
    const std::vector<NodeMotion> here = state.trial;
    for (const auto& group : groups_) {
        move(*system_, integrator, stage, group, 1.0, state);
        system_->compute_residual(state, time, forward_, forces);
        state.trial = here;
        move(*system_, integrator, stage, group, -1.0, state);
        system_->compute_residual(state, time, backward_, forces);
        state.trial = here;
        const Eigen::VectorXd change =
            gather(forward_.nodal, system_->equations()) - gather(backward_.nodal, system_->equations());
        for (const std::int64_t column : group) {
            const bool is_position = system_->equations().unknown(column).component < 3;
            const double width = 2.0 * step_angle * (is_position ? system_->length_scale() : 1.0);
            pattern.visit_column(
                column, [&](std::int64_t row, std::int64_t slot) { values[slot] = change[row] / width; });
        }
    }
    update_trial_rates(*system_, integrator, stage, state);
    if (request.added != nullptr) {
        for (std::size_t i = 0; i < values.size(); ++i) values[i] += (*request.added)[i];
    }
    add_joint_rows(*system_, integrator, stage, request, state, values);
}

}  // namespace gxrod
