#include "assembly/node_groups.hpp"

#include <algorithm>

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

SparsePattern compute_pattern(const EquationNumbers& equations, std::span<const NodeGroup> groups) {
    const auto neighbours = compute_neighbours(equations.node_count(), groups);
    SparsePattern pattern;
    pattern.reserve(neighbours.size());
    std::vector<std::int64_t> rows;
    for (std::size_t node = 0; node < neighbours.size(); ++node) {
        rows.clear();
        for (const int other : neighbours[node]) {
            // Equations are numbered node by node, so the rows come out ascending.
            for (const std::int64_t row : equations.of_node(other)) {
                if (row >= 0) rows.push_back(row);
            }
        }
        const auto own = equations.of_node(static_cast<int>(node));
        const auto columns = std::count_if(own.begin(), own.end(), [](std::int64_t row) { return row >= 0; });
        pattern.add_columns(columns, rows);
    }
    return pattern;
}

}  // namespace gxrod
