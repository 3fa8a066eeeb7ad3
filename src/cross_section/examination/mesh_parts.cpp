#include "cross_section/examination/mesh_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>

#include "numerics/disjoint_sets.hpp"

namespace gxrod {
namespace {

// Corners of elements of different parts that coincide, in pairs.
struct CoincidentCorners {
    int count = 0;
    PlanePoint first = PlanePoint::Zero();
};

CoincidentCorners count_coincident_corners(const SectionMesh& mesh, DisjointSets& parts, double within) {
    std::set<int> corners;
    for (int cell = 0; cell < static_cast<int>(mesh.cells.size()); ++cell) {
        for (const CellSide& side : list_cell_sides(mesh, cell)) corners.insert(side.nodes.front());
    }
    std::vector<int> order(corners.begin(), corners.end());
    const auto y_of = [&](int node) { return node_of(mesh, node).x(); };
    std::ranges::sort(order, {}, y_of);
    CoincidentCorners found;
    for (std::size_t i = 0; i < order.size(); ++i) {
        for (std::size_t j = i + 1; j < order.size() && y_of(order[j]) - y_of(order[i]) <= within; ++j) {
            if (parts.find(order[i]) == parts.find(order[j])) continue;
            if ((node_of(mesh, order[i]) - node_of(mesh, order[j])).norm() > within) continue;
            if (found.count++ == 0) found.first = node_of(mesh, order[i]);
        }
    }
    return found;
}

}  // namespace

std::string place_text(const PlanePoint& at) { return fmt::format("({:.4g}, {:.4g})", at.x(), at.y()); }

PlanePoint middle_of(const SectionMesh& mesh, const SectionCell& cell) {
    PlanePoint sum = PlanePoint::Zero();
    for (const int node : cell.nodes) sum += node_of(mesh, node);
    return sum / static_cast<double>(cell.nodes.size());
}

std::string find_part_fault(const SectionMesh& mesh, double within) {
    DisjointSets parts(mesh.nodes.size());
    for (const SectionCell& cell : mesh.cells) {
        for (const int node : cell.nodes) parts.join(cell.nodes.front(), node);
    }
    std::map<int, const SectionCell*> first_cells;
    for (const SectionCell& cell : mesh.cells) first_cells.emplace(parts.find(cell.nodes.front()), &cell);
    if (first_cells.size() == 1) return {};
    const CoincidentCorners coincident = count_coincident_corners(mesh, parts, within);
    const PlanePoint here = middle_of(mesh, *first_cells.begin()->second);
    const PlanePoint there = middle_of(mesh, *std::next(first_cells.begin())->second);
    const std::string text = fmt::format("{} parts share no node", first_cells.size());
    if (coincident.count == 0)
        return fmt::format("{} and touch nowhere, one at {}, one at {}: a section is one piece",
                           text,
                           place_text(here),
                           place_text(there));
    return fmt::format("{}; {} of their corners coincide, the first at {}: merge them (Gmsh: Coherence Mesh)",
                       text,
                       coincident.count,
                       place_text(coincident.first));
}

std::string find_pivot_fault(const SectionMesh& mesh, const MeshSides& sides) {
    DisjointSets parts(mesh.cells.size());
    for (const auto& [a, b] : sides.neighbours) parts.join(a, b);
    for (std::size_t cell = 1; cell < mesh.cells.size(); ++cell) {
        if (parts.find(static_cast<int>(cell)) == parts.find(0)) continue;
        return fmt::format(
            "the part at {} is joined to the rest at single nodes only, and would turn about them",
            place_text(middle_of(mesh, mesh.cells[cell])));
    }
    return {};
}

}  // namespace gxrod
