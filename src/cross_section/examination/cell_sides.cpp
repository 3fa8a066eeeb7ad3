#include "cross_section/examination/cell_sides.hpp"

#include <algorithm>
#include <map>

namespace gxrod {

std::vector<CellSide> list_cell_sides(const SectionMesh& mesh, int index) {
    const SectionCell& cell = mesh.cells[static_cast<std::size_t>(index)];
    const int p = cell.order;
    const bool is_quad = cell.shape == CellShape::quad;
    const auto node = [&](int i, int j) {
        const int before = is_quad ? j * (p + 1) : j * (p + 1) - j * (j - 1) / 2;
        const int at = before + i;
        return cell.nodes[static_cast<std::size_t>(at)];
    };
    std::vector<CellSide> sides(is_quad ? 4 : 3, CellSide{index, {}});
    for (int k = 0; k <= p; ++k) {
        sides[0].nodes.push_back(node(k, 0));
        sides[1].nodes.push_back(is_quad ? node(p, k) : node(p - k, k));
        sides[2].nodes.push_back(is_quad ? node(p - k, p) : node(0, p - k));
        if (is_quad) sides[3].nodes.push_back(node(0, p - k));
    }
    return sides;
}

MeshSides sort_sides(const SectionMesh& mesh) {
    std::map<std::vector<int>, std::vector<CellSide>> by_nodes;
    for (int cell = 0; cell < static_cast<int>(mesh.cells.size()); ++cell) {
        for (CellSide& side : list_cell_sides(mesh, cell)) {
            std::vector<int> key = side.nodes;
            std::ranges::sort(key);
            by_nodes[std::move(key)].push_back(std::move(side));
        }
    }
    MeshSides sorted;
    for (const auto& [key, sides] : by_nodes) {
        if (sides.size() == 1) {
            sorted.boundary.push_back(sides.front());
        } else if (sides.size() > 2 || sides[0].nodes.front() == sides[1].nodes.front()) {
            sorted.repeated.push_back(sides[1]);
        } else {
            sorted.neighbours.emplace_back(sides[0].cell, sides[1].cell);
        }
    }
    return sorted;
}

}  // namespace gxrod
