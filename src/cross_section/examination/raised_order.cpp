#include "cross_section/examination/raised_order.hpp"

#include <array>
#include <cassert>
#include <map>
#include <utility>

#include "cross_section/reference_cell.hpp"

namespace gxrod {
namespace {

// Where a node of a lattice is: between two corners, `step` of `order` steps from the first one; or, without
// corners, inside.
struct LatticePlace {
    int first = -1, second = -1,
        step = 0;  // corners: 0 at (0, 0), 1 at (order, 0), 2 at (0, order), 3 opposite
};

LatticePlace find_lattice_place(CellShape shape, int order, int i, int j) {
    if (j == 0) return {0, 1, i};
    if (i == 0) return {0, 2, j};
    if (shape == CellShape::triangle) return i + j == order ? LatticePlace{1, 2, j} : LatticePlace{};
    if (i == order) return {1, 3, j};
    return j == order ? LatticePlace{2, 3, i} : LatticePlace{};
}

// Indices of the corners in SectionCell::nodes.
std::array<std::size_t, 4> list_corners(CellShape shape, int order) {
    const auto p = static_cast<std::size_t>(order);
    const auto last = static_cast<std::size_t>(count_nodes(shape, order)) - 1;
    if (shape == CellShape::triangle) return {0, p, last, last};
    return {0, p, p * (p + 1), last};
}

class OrderRaiser {
  public:
    explicit OrderRaiser(const SectionMesh& mesh) : old_(mesh) {}

    SectionMesh raise() {
        SectionMesh raised{
            .nodes = {}, .cells = {}, .layers = old_.layers, .sharp_corners = old_.sharp_corners};
        for (const SectionCell& cell : old_.cells) raised.cells.push_back(raise(cell));
        raised.nodes = std::move(nodes_);
        return raised;
    }

  private:
    SectionCell raise(const SectionCell& cell) {
        const int order = cell.order + 1;
        const CellShapes table = compute_cell_shapes(cell.shape, cell.order, list_lattice(cell.shape, order));
        const auto corners = list_corners(cell.shape, cell.order);
        SectionCell raised{
            .shape = cell.shape, .order = order, .layer = cell.layer, .nodes = {}, .walls = {}};
        for (int j = 0; j <= order; ++j) {
            for (int i = 0; i <= (cell.shape == CellShape::triangle ? order - j : order); ++i) {
                const auto row = static_cast<Eigen::Index>(raised.nodes.size());
                const LatticePlace place = find_lattice_place(cell.shape, order, i, j);
                const auto corner = [&](int k) { return cell.nodes[corners[static_cast<std::size_t>(k)]]; };
                const PlanePoint at = sum(table, row, cell, old_.nodes);
                raised.nodes.push_back(
                    place.first < 0 ? add(at)
                                    : find(corner(place.first), corner(place.second), place.step, order, at));
                if (cell.walls.empty()) continue;
                PlanePoint wall = PlanePoint::Zero();
                for (std::size_t k = 0; k < cell.walls.size(); ++k)
                    wall += table.values(row, static_cast<Eigen::Index>(k)) * cell.walls[k];
                raised.walls.push_back(wall.normalized());
            }
        }
        return raised;
    }

    static PlanePoint sum(const CellShapes& table,
                          Eigen::Index row,
                          const SectionCell& cell,
                          const std::vector<PlanePoint>& nodes) {
        PlanePoint at = PlanePoint::Zero();
        for (std::size_t k = 0; k < cell.nodes.size(); ++k)
            at += table.values(row, static_cast<Eigen::Index>(k)) *
                  nodes[static_cast<std::size_t>(cell.nodes[k])];
        return at;
    }

    int add(const PlanePoint& at) {
        nodes_.push_back(at);
        return static_cast<int>(nodes_.size()) - 1;
    }

    // The node of a side, which the cells on both of its sides share; a corner is a side of no length.
    int find(int first, int second, int step, int order, const PlanePoint& at) {
        std::array<int, 3> key{first, second, step};
        if (step == 0) key = {first, first, 0};
        if (step == order) key = {second, second, 0};
        if (key[0] > key[1]) key = {second, first, order - step};
        const auto [place, is_new] = known_.try_emplace(key, 0);
        if (is_new) place->second = add(at);
        return place->second;
    }

    const SectionMesh& old_;
    std::vector<PlanePoint> nodes_;
    std::map<std::array<int, 3>, int> known_;
};

}  // namespace

SectionMesh raise_order(const SectionMesh& mesh) { return OrderRaiser(mesh).raise(); }

}  // namespace gxrod
