#include "mesh/triangles/triangle_examination.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "mesh/triangles/triangle_edges.hpp"
#include "numerics/disjoint_sets.hpp"

namespace gxrod {
namespace {

// Of each part, those are flipped that are fewer; of as many, those that are turned.
void find_flipped(const TriangleMesh& mesh, Orientation& orientation, TriangleExamination& result) {
    std::vector<std::array<std::size_t, 2>> counts(static_cast<std::size_t>(orientation.count), {0, 0});
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        ++counts[static_cast<std::size_t>(orientation.parts[t])][orientation.is_turned[t] != 0 ? 1 : 0];
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto& count = counts[static_cast<std::size_t>(orientation.parts[t])];
        if (count[1] > count[0]) orientation.is_turned[t] = static_cast<char>(orientation.is_turned[t] == 0);
        if (orientation.is_turned[t] != 0) result.flipped.push_back(mesh.numbers[t]);
    }
}

void measure_triangles(const TriangleMesh& mesh,
                       const Orientation& orientation,
                       TriangleExamination& result) {
    double volume = 0.0;
    const Vec3 middle = 0.5 * (result.low + result.high);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const Vec3 area = find_area_vector(mesh, static_cast<int>(t));
        result.area += 0.5 * area.norm();
        const double sign = orientation.is_turned[t] != 0 ? -1.0 : 1.0;
        volume += sign * area.dot(corner_at(mesh, mesh.triangles[t][0]) - middle) / 6.0;
    }
    if (result.is_closed()) result.volume = std::abs(volume);
}

void measure_edges(const TriangleMesh& mesh, const SidesOfEdges& sides, TriangleExamination& result) {
    result.least_side = std::numeric_limits<double>::infinity();
    for (const auto& [edge, own] : sides) {
        const double length = (corner_at(mesh, edge.second) - corner_at(mesh, edge.first)).norm();
        result.least_side = std::min(result.least_side, length);
        result.greatest_side = std::max(result.greatest_side, length);
        if (own.size() == 1) result.open_edges.push_back({edge.first, edge.second});
        if (own.size() > 2) ++result.crowded_edges;
        if (own.size() != 2) continue;
        const double turn = find_turn(mesh, own);
        result.greatest_turn = std::max(result.greatest_turn, turn);
        if (turn > mesh.feature_angle) ++result.sharp_edges;
    }
}

void find_holes(const TriangleMesh& mesh, TriangleExamination& result) {
    DisjointSets corners(mesh.positions.size());
    for (const auto& [a, b] : result.open_edges) corners.join(a, b);
    std::map<int, MeshHole> holes;
    for (const auto& [a, b] : result.open_edges) {
        MeshHole& hole = holes[corners.find(a)];
        const double length = (corner_at(mesh, b) - corner_at(mesh, a)).norm();
        hole.middle += 0.5 * length * (corner_at(mesh, a) + corner_at(mesh, b));
        hole.length += length;
        ++hole.edges;
    }
    for (auto& [corner, hole] : holes) {
        hole.middle /= hole.length;
        result.holes.push_back(hole);
    }
    std::ranges::stable_sort(result.holes, std::greater(), &MeshHole::length);
}

}  // namespace

TriangleExamination examine_triangles(const TriangleMesh& mesh) {
    TriangleExamination result;
    result.low = result.high = corner_at(mesh, mesh.triangles.front()[0]);
    for (const std::array<int, 3>& corners : mesh.triangles) {
        for (const int corner : corners) {
            result.low = result.low.cwiseMin(corner_at(mesh, corner));
            result.high = result.high.cwiseMax(corner_at(mesh, corner));
        }
    }
    const SidesOfEdges sides = list_sides(mesh);
    Orientation orientation = orient_triangles(mesh, sides);
    result.parts = static_cast<std::size_t>(orientation.count);
    find_flipped(mesh, orientation, result);
    measure_edges(mesh, sides, result);
    measure_triangles(mesh, orientation, result);
    find_holes(mesh, result);
    return result;
}

}  // namespace gxrod
