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

// Adds the tangent by the matrix of each node, in the place of its linearization that `set` names.
template <class Set>
void add_by_spins(const System& system,
                  const State& state,
                  double time,
                  const std::vector<Mat3>& spins,
                  Set&& set,
                  std::vector<double>& sum) {
    std::vector<NodeLinearization> ask(state.trial.size());
    for (std::size_t node = 0; node < ask.size(); ++node) set(ask[node]) = spins[node];
    std::vector<double> values;
    system.compute_tangent(state, time, ask, values);
    for (std::size_t i = 0; i < values.size(); ++i) sum[i] += values[i];
}

}  // namespace

Model without_supports(Model model) {
    model.plane.reset();
    model.supports.clear();
    return model;
}

FrameColumns::Free::Free(const System& held)
    : model(without_supports(held.model())), system(model, held.team()) {}

FrameColumns::FrameColumns(const System& system, TurningFrame frame)
    : system_(&system), frame_(std::move(frame)) {
    if (frame_.is_at_rest()) return;
    free_ = std::make_unique<const Free>(system);
    list_pairs();
}

// Rows that belong to no node, such as those of joints, have no rates.
void FrameColumns::list_pairs() {
    const EquationNumbers& equations = free_->system.equations();
    const SparsePattern& pattern = free_->system.pattern();
    const int count = static_cast<int>(equations.node_count());
    std::vector<int> nodes(static_cast<std::size_t>(equations.count()), -1);
    for (int node = 0; node < count; ++node) nodes[static_cast<std::size_t>(equations.first_of(node))] = node;
    for (int column = 0; column < count; ++column) {
        const std::int64_t first = equations.first_of(column);
        const SparsePattern::Block block = pattern.block_of(first);
        for (const SparsePattern::RowRun& run : block.runs) {
            for (std::int64_t row = run.first; row < run.first + run.count; ++row) {
                const int row_node = nodes[static_cast<std::size_t>(row)];
                if (row_node < 0) continue;
                Pair pair{row_node, column, pattern.slot(row, first), block.stride, {}};
                const auto rows = system_->equations().of_node(row_node);
                const auto columns = system_->equations().of_node(column);
                for (int i = 0; i < 36; ++i) {
                    const bool is_free = rows[i % 6] >= 0 && columns[i / 6] >= 0;
                    pair.slots[i] = is_free ? system_->pattern().slot(rows[i % 6], columns[i / 6]) : -1;
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
    const std::vector<double> C = compute(free_->system, state, time, {.rate = 1.0});
    const std::vector<double> M = compute(free_->system, state, time, {.acceleration = 1.0});
    const Mat3 spin = cross_matrix<double>(frame_.spin(time));
    const EquationNumbers& equations = system_->equations();
    const auto add = [&](const Pair& pair, const NodeColumns& columns, std::vector<double>& values) {
        Vec6 own;
        for (int column = 0; column < 6; ++column) {
            // Of a displacement along one of the node's own axes.
            const Vec6 along = equations.to_global_axes(pair.column_node, Vec6::Unit(column));
            own = equations.to_own_axes(pair.row_node, columns * along.head<3>());
            for (int row = 0; row < 6; ++row) {
                const std::int64_t slot =
                    pair.slots[6 * static_cast<std::size_t>(column) + static_cast<std::size_t>(row)];
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

std::vector<Mat3> FrameColumns::list_spins(const State& state, double time) const {
    std::vector<Mat3> spins;
    for (std::size_t node = 0; node < state.trial.size(); ++node)
        spins.emplace_back(-cross_matrix<double>(frame_.spin_of(node, state.trial[node].Lambda, time)));
    return spins;
}

void FrameColumns::add_stiffness(const State& state, double time, std::vector<double>& values) const {
    if (free_) return add_columns(state, time, values, nullptr);
    const auto d_omega = [](NodeLinearization& ask) -> Mat3& { return ask.d_omega; };
    add_by_spins(*system_, state, time, list_spins(state, time), d_omega, values);
}

StateMatrices FrameColumns::compute_matrices(const State& state, double time) const {
    if (!state.resultants.empty()) {
        State bare = state;
        bare.resultants.clear();
        return compute_matrices(bare, time);
    }
    StateMatrices matrices = compute_state_matrices(*system_, state, time);
    // δα of ψ′, which nodes at rest do not have.
    const auto d_alpha = [](NodeLinearization& ask) -> Mat3& { return ask.d_alpha; };
    if (!free_) {
        add_by_spins(*system_, state, time, list_spins(state, time), d_alpha, matrices.damping);
        add_stiffness(state, time, matrices.stiffness);
        return matrices;
    }
    const std::vector<Mat3> spins(state.trial.size(), cross_matrix<double>(frame_.spin(time)));
    add_by_spins(*system_, state, time, spins, d_alpha, matrices.damping);
    add_columns(state, time, matrices.stiffness, &matrices.damping);
    return matrices;
}

}  // namespace gxrod
