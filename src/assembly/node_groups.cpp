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
        // Equations are numbered node by node, so the rows come out ascending.
        for (const int other : neighbours[node]) {
            for (std::int64_t row = equations.first_of(other); row < equations.end_of(other); ++row)
                rows.push_back(row);
        }
        const int index = static_cast<int>(node);
        const std::int64_t columns = equations.end_of(index) - equations.first_of(index);
        pattern.add_columns(columns, rows);
    }
    return pattern;
}

}  // namespace gxrod
