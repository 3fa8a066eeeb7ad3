#include "mesh/sections/surface_cells.hpp"

#include <algorithm>

namespace gxrod {
namespace {

using LatticePlaces = std::vector<std::pair<int, int>>;

// The places of an element's nodes on the lattice of a cell, in Gmsh's order: corners, sides, then inside.
LatticePlaces list_gmsh_places(CellShape shape, int order) {
    const int p = order;
    LatticePlaces places = shape == CellShape::triangle ? LatticePlaces{{0, 0}, {p, 0}, {0, p}}
                                                        : LatticePlaces{{0, 0}, {p, 0}, {p, p}, {0, p}};
    const std::size_t corners = places.size();
    for (std::size_t side = 0; side < corners; ++side) {
        const auto [i, j] = places[side];
        const auto [next_i, next_j] = places[(side + 1) % corners];
        for (int k = 1; k < p; ++k) places.emplace_back(i + (next_i - i) / p * k, j + (next_j - j) / p * k);
    }
    if (shape == CellShape::quad && p == 2) places.emplace_back(1, 1);
    if (shape == CellShape::quad && p == 3) places.insert(places.end(), {{1, 1}, {2, 1}, {2, 2}, {1, 2}});
    if (shape == CellShape::triangle && p == 3) places.emplace_back(1, 1);
    return places;
}

std::size_t lattice_index(CellShape shape, int order, int i, int j) {
    const int before = shape == CellShape::quad ? j * (order + 1) : j * (order + 1) - j * (j - 1) / 2;
    const int at = before + i;
    return static_cast<std::size_t>(at);
}

struct ElementType {
    CellShape shape;
    int order;
};

ElementType type_of(const SurfaceElement& element) {
    switch (element.nodes.size()) {
        case 3:
            return {CellShape::triangle, 1};
        case 6:
            return {CellShape::triangle, 2};
        case 10:
            return {CellShape::triangle, 3};
        case 4:
            return {CellShape::quad, 1};
        case 16:
            return {CellShape::quad, 3};
        default:
            return {CellShape::quad, 2};
    }
}

SectionCell make_cell(ElementType type, int layer) {
    SectionCell cell;
    cell.shape = type.shape;
    cell.order = type.order;
    cell.layer = layer;
    cell.nodes.resize(static_cast<std::size_t>(count_nodes(type.shape, type.order)));
    return cell;
}

// Walks a cell the other way: i and j change places.
void turn_over(SectionCell& cell) {
    const std::vector<int> nodes = cell.nodes;
    for (int j = 0; j <= cell.order; ++j) {
        const int last = cell.shape == CellShape::quad ? cell.order : cell.order - j;
        for (int i = 0; i <= last; ++i) {
            cell.nodes[lattice_index(cell.shape, cell.order, i, j)] =
                nodes[lattice_index(cell.shape, cell.order, j, i)];
        }
    }
}

}  // namespace

SectionCell SurfaceCells::make(const SurfaceElement& element, int layer) {
    const ElementType type = type_of(element);
    SectionCell cell = make_cell(type, layer);
    const LatticePlaces places = list_gmsh_places(type.shape, type.order);
    std::vector<int> nodes = element.nodes;
    if (nodes.size() == 8) {
        PlanePoint middle = PlanePoint::Zero();
        for (std::size_t i = 0; i < 8; ++i) middle += (i < 4 ? -0.25 : 0.5) * at(nodes[i]);
        nodes.push_back(add_node(middle));
    }
    for (std::size_t i = 0; i < places.size(); ++i)
        cell.nodes[lattice_index(type.shape, type.order, places[i].first, places[i].second)] = nodes[i];
    if (is_clockwise(cell)) turn_over(cell);
    return cell.order == 1 ? raise(cell) : cell;
}

SectionCell SurfaceCells::raise(const SectionCell& straight) {
    constexpr int order = 3;
    SectionCell cell = make_cell({straight.shape, order}, straight.layer);
    const bool is_quad = straight.shape == CellShape::quad;
    const std::vector<int> corners =
        is_quad ? std::vector<int>{straight.nodes[0], straight.nodes[1], straight.nodes[3], straight.nodes[2]}
                : straight.nodes;
    std::vector<int> nodes = corners;
    for (std::size_t side = 0; side < corners.size(); ++side) {
        for (const int node : nodes_on_side(corners[side], corners[(side + 1) % corners.size()]))
            nodes.push_back(node);
    }
    const LatticePlaces places = list_gmsh_places(straight.shape, order);
    for (std::size_t k = nodes.size(); k < places.size(); ++k) {
        const double u = places[k].first / 3.0, v = places[k].second / 3.0;
        const PlanePoint &a = at(corners[0]), &b = at(corners[1]), &c = at(corners[2]);
        const PlanePoint inside = is_quad ? PlanePoint((1 - u) * (1 - v) * a + u * (1 - v) * b + u * v * c +
                                                       (1 - u) * v * at(corners[3]))
                                          : PlanePoint((1 - u - v) * a + u * b + v * c);
        nodes.push_back(add_node(inside));
    }
    for (std::size_t k = 0; k < places.size(); ++k)
        cell.nodes[lattice_index(straight.shape, order, places[k].first, places[k].second)] = nodes[k];
    return cell;
}

std::array<int, 2> SurfaceCells::nodes_on_side(int from, int to) {
    const auto [first, second] = std::minmax(from, to);
    const auto [found, is_new] = sides_.try_emplace({first, second});
    if (is_new) {
        const PlanePoint a = at(first), b = at(second);
        found->second[0] = add_node((2.0 * a + b) / 3.0);
        found->second[1] = add_node((a + 2.0 * b) / 3.0);
    }
    const auto [near_first, near_second] = found->second;
    return from == first ? std::array{near_first, near_second} : std::array{near_second, near_first};
}

int SurfaceCells::add_node(const PlanePoint& place) {
    mesh_.nodes.push_back(place);
    return static_cast<int>(mesh_.nodes.size()) - 1;
}

bool SurfaceCells::is_clockwise(const SectionCell& cell) const {
    const int p = cell.order;
    const PlanePoint& origin = at(cell.nodes[0]);
    const auto arm = [&](int i, int j) -> PlanePoint {
        return at(cell.nodes[lattice_index(cell.shape, p, i, j)]) - origin;
    };
    PlanePoint a = arm(p, 0), b = arm(0, p);
    if (cell.shape == CellShape::quad) {
        // Of a quadrilateral: its diagonals.
        const PlanePoint across = arm(p, p);
        b -= a;
        a = across;
    }
    return a.x() * b.y() - a.y() * b.x() < 0.0;
}

}  // namespace gxrod
