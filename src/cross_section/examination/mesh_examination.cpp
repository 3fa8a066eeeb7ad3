#include "cross_section/examination/mesh_examination.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "cross_section/examination/cell_sides.hpp"
#include "cross_section/examination/mesh_parts.hpp"
#include "cross_section/examination/segment_crossing.hpp"
#include "cross_section/reference_cell.hpp"

namespace gxrod {
namespace {

// Lengths next to the extent of a mesh: nodes as close as this coincide, and lie on a side.
constexpr double coincidence = 1e-7;
// A cell has an area if its map is nowhere smaller than this, over the square of its longest side.
constexpr double least_area = 1e-6;
// At its nodes the map may be this much below zero: quadrangles with two sides on a smooth curve are flat
// there.
constexpr double flat_corner = 0.01;

double find_mesh_extent(const SectionMesh& mesh) {
    PlanePoint low = mesh.nodes.front(), high = low;
    for (const PlanePoint& node : mesh.nodes) {
        low = low.cwiseMin(node);
        high = high.cwiseMax(node);
    }
    return (high - low).maxCoeff();
}

// The tables of shape functions that a mesh needs.
class MapTables {
  public:
    // Returns the least determinant of a cell's map at its nodes and within, over the square of its size.
    double find_least_determinant(const SectionMesh& mesh, const SectionCell& cell) {
        const auto kind = std::pair(cell.shape, cell.order);
        const ReferenceCell& reference = tables_.try_emplace(kind, cell.shape, cell.order).first->second;
        Eigen::MatrixX2d nodes(static_cast<Eigen::Index>(cell.nodes.size()), 2);
        for (Eigen::Index i = 0; i < nodes.rows(); ++i)
            nodes.row(i) = node_of(mesh, cell.nodes[static_cast<std::size_t>(i)]).transpose();
        const double size = (nodes.colwise().maxCoeff() - nodes.colwise().minCoeff()).maxCoeff();
        const double least = std::min(find_least(reference.at_points, nodes),
                                      find_least(reference.at_nodes, nodes) + flat_corner * size * size);
        return size > 0.0 ? least / (size * size) : 0.0;
    }

  private:
    static double find_least(const CellShapes& table, const Eigen::MatrixX2d& nodes) {
        const Eigen::MatrixX2d a = table.slopes_1 * nodes, b = table.slopes_2 * nodes;
        const Eigen::ArrayXd determinants =
            a.col(0).array() * b.col(1).array() - a.col(1).array() * b.col(0).array();
        return determinants.minCoeff();
    }

    std::map<std::pair<CellShape, int>, ReferenceCell> tables_;
};

std::string find_area_fault(const SectionMesh& mesh) {
    MapTables tables;
    for (const SectionCell& cell : mesh.cells) {
        if (tables.find_least_determinant(mesh, cell) > least_area) continue;
        return fmt::format("the element near {} is inside out or has no area",
                           place_text(middle_of(mesh, cell)));
    }
    return {};
}

std::string find_repeated_fault(const SectionMesh& mesh, const MeshSides& sides) {
    if (sides.repeated.empty()) return {};
    const SectionCell& cell = mesh.cells[static_cast<std::size_t>(sides.repeated.front().cell)];
    return fmt::format("elements overlap near {}: two lie on the same side of an edge",
                       place_text(middle_of(mesh, cell)));
}

std::vector<PlaneSegment> list_boundary(const SectionMesh& mesh, const MeshSides& sides) {
    std::vector<PlaneSegment> segments;
    for (const CellSide& side : sides.boundary) {
        for (std::size_t i = 0; i + 1 < side.nodes.size(); ++i)
            segments.push_back({node_of(mesh, side.nodes[i]), node_of(mesh, side.nodes[i + 1]), side.cell});
    }
    return segments;
}

// Whether an element with a node has its middle to the left of a side, where that side has its own element.
bool is_on_left(const SectionMesh& mesh, int node, const PlanePoint& from, const PlanePoint& along) {
    return std::ranges::any_of(mesh.cells, [&](const SectionCell& cell) {
        if (std::ranges::find(cell.nodes, node) == cell.nodes.end()) return false;
        const PlanePoint to = middle_of(mesh, cell) - from;
        return along.x() * to.y() > along.y() * to.x();
    });
}

// A node of the boundary that lies on a side to which it does not belong.
std::string find_hanging_fault(const SectionMesh& mesh, const MeshSides& sides, double extent) {
    std::set<int> on_boundary;
    for (const CellSide& side : sides.boundary) on_boundary.insert(side.nodes.begin(), side.nodes.end());
    std::vector<int> nodes(on_boundary.begin(), on_boundary.end());
    const auto y_of = [&](int node) { return node_of(mesh, node).x(); };
    std::ranges::sort(nodes, {}, y_of);
    const double within = coincidence * extent;
    for (const CellSide& side : sides.boundary) {
        for (std::size_t k = 0; k + 1 < side.nodes.size(); ++k) {
            const PlanePoint from = node_of(mesh, side.nodes[k]),
                             along = node_of(mesh, side.nodes[k + 1]) - from;
            const double low = std::min(from.x(), from.x() + along.x()) - within;
            const double high = std::max(from.x(), from.x() + along.x()) + within;
            for (auto node = std::ranges::lower_bound(nodes, low, {}, y_of);
                 node != nodes.end() && y_of(*node) <= high;
                 ++node) {
                if (std::ranges::find(side.nodes, *node) != side.nodes.end()) continue;
                const PlanePoint to = node_of(mesh, *node) - from;
                const double place = to.dot(along) / along.squaredNorm();
                if (place < -1e-6 || place > 1.0 + 1e-6 || (to - place * along).norm() > within) continue;
                if (is_on_left(mesh, *node, from, along))
                    return "elements overlap near " + place_text(node_of(mesh, *node));
                return fmt::format(
                    "the side from {} to {} has a node of another element on it, at {}, that it does not "
                    "share",
                    place_text(node_of(mesh, side.nodes.front())),
                    place_text(node_of(mesh, side.nodes.back())),
                    place_text(node_of(mesh, *node)));
            }
        }
    }
    return {};
}

std::string find_overlap_fault(const SectionMesh& mesh, const MeshSides& sides) {
    const std::optional<SegmentCrossing> found = find_crossing(list_boundary(mesh, sides));
    return found ? fmt::format("elements overlap near {}", place_text(found->at)) : "";
}

}  // namespace

std::string find_mesh_fault(const SectionMesh& mesh) {
    if (mesh.cells.empty()) return "has no elements";
    const double extent = find_mesh_extent(mesh);
    std::string fault = find_area_fault(mesh);
    if (fault.empty()) fault = find_part_fault(mesh, coincidence * extent);
    if (!fault.empty()) return fault;
    const MeshSides sides = sort_sides(mesh);
    fault = find_repeated_fault(mesh, sides);
    if (fault.empty()) fault = find_hanging_fault(mesh, sides, extent);
    if (fault.empty()) fault = find_overlap_fault(mesh, sides);
    return fault.empty() ? find_pivot_fault(mesh, sides) : fault;
}

}  // namespace gxrod
