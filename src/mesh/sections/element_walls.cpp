#include "mesh/sections/element_walls.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

namespace gxrod {
namespace {

using CornerAngles = std::array<double, 4>;  // at (0, 0), (order, 0), (0, order), (order, order)

PlanePoint direction_at(double angle) { return {std::cos(angle), std::sin(angle)}; }

// Angles of the nodes of a surface, each less than half a turn from the first.
std::map<int, double> unwrap_angles(const SurfaceElement& surface, const std::vector<double>& angles) {
    constexpr double turn = 2.0 * std::numbers::pi;
    std::map<int, double> by_node;
    for (std::size_t i = 0; i < angles.size(); ++i)
        by_node[surface.nodes[i]] = angles[0] + std::remainder(angles[i] - angles[0], turn);
    return by_node;
}

CornerAngles find_corner_angles(const SectionCell& cell, const std::map<int, double>& by_node) {
    const auto at = [&](std::size_t index) { return by_node.at(cell.nodes[index]); };
    const auto order = static_cast<std::size_t>(cell.order);
    const std::size_t last = cell.nodes.size() - 1;
    if (cell.shape == CellShape::triangle) return {at(0), at(order), at(last), 0.0};
    return {at(0), at(order), at(last - order), at(last)};
}

}  // namespace

void paint_by_angle(double angle, SectionCell& cell) {
    cell.walls.assign(cell.nodes.size(), direction_at(angle));
}

void paint_by_data(const SurfaceMesh& mesh, std::size_t surface, const SurfaceData& data, SectionCell& cell) {
    const SurfaceElement& element = mesh.surfaces[surface];
    const std::vector<double>& angles = data.values[surface];
    const bool is_finite = std::ranges::all_of(angles, [](double angle) { return std::isfinite(angle); });
    if (angles.size() == 1 && is_finite) return paint_by_angle(angles[0], cell);
    if (angles.size() != element.nodes.size() || !is_finite) {
        const Vec3& at = mesh.positions[static_cast<std::size_t>(element.nodes.front())];
        throw MeshError(
            fmt::format("the data \"{}\" have no angle of the surface at ({:.4g}, {:.4g}, {:.4g})",
                        data.name,
                        at.x(),
                        at.y(),
                        at.z()));
    }
    const std::map<int, double> by_node = unwrap_angles(element, angles);
    const auto [a, b, c, d] = find_corner_angles(cell, by_node);
    const bool is_quad = cell.shape == CellShape::quad;
    std::size_t index = 0;
    for (int j = 0; j <= cell.order; ++j) {
        for (int i = 0; i <= (is_quad ? cell.order : cell.order - j); ++i, ++index) {
            const double u = static_cast<double>(i) / cell.order, v = static_cast<double>(j) / cell.order;
            const double between = is_quad
                                       ? (1 - u) * (1 - v) * a + u * (1 - v) * b + (1 - u) * v * c + u * v * d
                                       : (1 - u - v) * a + u * b + v * c;
            const auto own = by_node.find(cell.nodes[index]);
            cell.walls.push_back(direction_at(own == by_node.end() ? between : own->second));
        }
    }
}

}  // namespace gxrod
