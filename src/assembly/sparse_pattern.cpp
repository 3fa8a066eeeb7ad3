#include "assembly/sparse_pattern.hpp"

#include <algorithm>
#include <cassert>

namespace gxrod {

namespace {

// For each node the nodes that share an element with it, itself included, ascending.
std::vector<std::vector<int>> compute_neighbours(std::size_t node_count, std::span<const NodeGroup> groups) {
    std::vector<std::vector<int>> neighbours(node_count);
    for (const NodeGroup& group : groups) {
        for (const int node : group) {
            neighbours[node].insert(neighbours[node].end(), group.begin(), group.end());
        }
    }
    for (auto& list : neighbours) {
        std::sort(list.begin(), list.end());
        list.erase(std::unique(list.begin(), list.end()), list.end());
    }
    return neighbours;
}

}  // namespace

std::int64_t SparsePattern::slot(std::int64_t row, std::int64_t column) const {
    const auto first = rows.begin() + column_starts[column];
    const auto last = rows.begin() + column_starts[column + 1];
    const auto found = std::lower_bound(first, last, row);
    assert(found != last && *found == row);
    return found - rows.begin();
}

SparsePattern compute_pattern(const EquationNumbers& equations, std::span<const NodeGroup> groups) {
    const auto neighbours = compute_neighbours(equations.node_count(), groups);
    const auto count_equations = [&](int node) {
        const auto& numbers = equations.of_node(node);
        return std::count_if(numbers.begin(), numbers.end(), [](std::int64_t row) { return row >= 0; });
    };
    std::int64_t nonzeros = 0;
    for (std::size_t node = 0; node < neighbours.size(); ++node) {
        std::int64_t rows = 0;
        for (const int other : neighbours[node]) rows += count_equations(other);
        nonzeros += rows * count_equations(static_cast<int>(node));
    }
    SparsePattern pattern;
    pattern.rows.reserve(static_cast<std::size_t>(nonzeros));
    pattern.column_starts.reserve(static_cast<std::size_t>(equations.count()) + 1);
    pattern.column_starts.push_back(0);
    for (const auto& unknown : equations.unknowns()) {
        for (const int node : neighbours[unknown.node]) {
            // Equations are numbered node by node, so the rows come out ascending.
            for (const std::int64_t row : equations.of_node(node)) {
                if (row >= 0) pattern.rows.push_back(row);
            }
        }
        pattern.column_starts.push_back(pattern.nonzeros());
    }
    return pattern;
}

}  // namespace gxrod
