#include "assembly/lanes/frame_columns.hpp"

#include "assembly/scatter.hpp"
#include "rotation/cross_products.hpp"

namespace gxrod {

namespace {

using NodeColumns = Eigen::Matrix<double, 6, 3>;  // of its displacement

NodeColumns read_columns(const std::vector<double>& values, std::int64_t first, std::int64_t stride) {
    NodeColumns columns;
    for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < 6; ++row)
            columns(row, column) = values[static_cast<std::size_t>(first + column * stride + row)];
    }
    return columns;
}

std::vector<double> compute(const System& system,
                            const State& state,
                            double time,
                            const NodeLinearization& ask) {
    std::vector<double> values;
    system.compute_tangent(state, time, std::vector<NodeLinearization>(state.trial.size(), ask), values);
    return values;
}

}  // namespace

Model without_supports(const Model& model) {
    Model other = model;
    other.plane.reset();
    other.supports.clear();
    // Joints follow a rigid motion without a force: a frame that turns adds nothing to theirs.
    other.joints.clear();
    other.gears.clear();
    other.sleeves.clear();
    std::erase_if(other.tendons, [](const Tendon& tendon) { return tendon.winch.has_value(); });
    return other;
}

FrameColumns::FrameColumns(const System& system, TurningFrame frame)
    : system_(&system),
      frame_(std::move(frame)),
      model_(without_supports(system.model())),
      free_(model_, system.team()) {
    const SparsePattern& pattern = free_.pattern();
    for (int column = 0; column < static_cast<int>(model_.nodes.size()); ++column) {
        const SparsePattern::Block block = pattern.block_of(6 * static_cast<std::int64_t>(column));
        for (const SparsePattern::RowRun& run : block.runs) {
            for (std::int64_t row = run.first; row < run.first + run.count; row += 6) {
                Pair pair{static_cast<int>(row / 6),
                          column,
                          pattern.slot(row, 6 * std::int64_t{column}),
                          block.stride,
                          {}};
                const auto rows = system.equations().of_node(pair.row_node);
                const auto columns = system.equations().of_node(pair.column_node);
                for (int i = 0; i < 36; ++i) {
                    const bool is_free = rows[i % 6] >= 0 && columns[i / 6] >= 0;
                    pair.slots[i] = is_free ? system.pattern().slot(rows[i % 6], columns[i / 6]) : -1;
                }
                pairs_.push_back(pair);
            }
        }
    }
}

void FrameColumns::add_columns(const State& state,
                               double time,
                               std::vector<double>& stiffness,
                               std::vector<double>* damping) const {
    const std::vector<double> C = compute(free_, state, time, {.rate = 1.0});
    const std::vector<double> M = compute(free_, state, time, {.acceleration = 1.0});
    const Mat3 spin = cross_matrix<double>(frame_.spin(time));
    const EquationNumbers& equations = system_->equations();
    const auto add = [&](const Pair& pair, const NodeColumns& columns, std::vector<double>& values) {
        Vec6 own;
        for (int column = 0; column < 6; ++column) {
            // Of a displacement along one of the node's own axes.
            const Vec6 along = equations.to_global_axes(pair.column_node, Vec6::Unit(column));
            own = equations.to_own_axes(pair.row_node, columns * along.head<3>());
            for (int row = 0; row < 6; ++row) {
                const std::int64_t slot = pair.slots[static_cast<std::size_t>(6 * column + row)];
                if (slot >= 0) values[static_cast<std::size_t>(slot)] += own[row];
            }
        }
    };
    for (const Pair& pair : pairs_) {
        const NodeColumns rate = read_columns(C, pair.first, pair.stride);
        const NodeColumns mass = read_columns(M, pair.first, pair.stride);
        add(pair, (rate + mass * spin) * spin, stiffness);
        if (damping) add(pair, 2.0 * mass * spin, *damping);
    }
}

void FrameColumns::add_stiffness(const State& state, double time, std::vector<double>& values) const {
    add_columns(state, time, values, nullptr);
}

StateMatrices FrameColumns::compute_matrices(const State& state, double time) const {
    if (!state.resultants.empty()) {
        State bare = state;
        bare.resultants.clear();
        return compute_matrices(bare, time);
    }
    StateMatrices matrices = compute_state_matrices(*system_, state, time);
    // δα of ψ′, which a frame at rest does not have.
    const std::vector<double> gyroscopic =
        compute(*system_, state, time, {.d_alpha = cross_matrix<double>(frame_.spin(time))});
    for (std::size_t i = 0; i < gyroscopic.size(); ++i) matrices.damping[i] += gyroscopic[i];
    add_columns(state, time, matrices.stiffness, &matrices.damping);
    return matrices;
}

}  // namespace gxrod
