#include "mesh/triangle_examination.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "numerics/disjoint_sets.hpp"

namespace gxrod {
namespace {

// A triangle along an edge: whether it goes from the corner with the lower number to the other one.
struct EdgeSide {
    int triangle = 0;
    bool goes_up = false;
};
using SidesOfEdges = std::map<std::pair<int, int>, std::vector<EdgeSide>>;

SidesOfEdges list_sides(const TriangleMesh& mesh) {
    SidesOfEdges sides;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        for (std::size_t i = 0; i < 3; ++i) {
            const int a = mesh.triangles[t][i], b = mesh.triangles[t][(i + 1) % 3];
            sides[std::minmax(a, b)].push_back({static_cast<int>(t), a < b});
        }
    }
    return sides;
}

const Vec3& corner_at(const TriangleMesh& mesh, int corner) {
    return mesh.positions[static_cast<std::size_t>(corner)];
}

// Twice the area, along the normal of its order of corners.
Vec3 find_area_vector(const TriangleMesh& mesh, int triangle) {
    const auto& [a, b, c] = mesh.triangles[static_cast<std::size_t>(triangle)];
    return (corner_at(mesh, b) - corner_at(mesh, a)).cross(corner_at(mesh, c) - corner_at(mesh, a));
}

// Which triangles are the other way around than the first of their part, and the part of each.
struct Orientation {
    std::vector<char> is_turned;
    std::vector<int> parts;
    int count = 0;
};

Orientation orient(const TriangleMesh& mesh, const SidesOfEdges& sides) {
    std::vector<std::vector<std::pair<int, bool>>> neighbours(mesh.triangles.size());
    for (const auto& [edge, own] : sides) {
        for (std::size_t k = 1; k < own.size(); ++k) {
            // Two that go along the edge in the same direction face opposite ways; of more than two none
            // does.
            const bool is_opposite = own.size() == 2 && own[0].goes_up == own[1].goes_up;
            neighbours[static_cast<std::size_t>(own[0].triangle)].emplace_back(own[k].triangle, is_opposite);
            neighbours[static_cast<std::size_t>(own[k].triangle)].emplace_back(own[0].triangle, is_opposite);
        }
    }
    Orientation found{std::vector<char>(mesh.triangles.size(), 0),
                      std::vector<int>(mesh.triangles.size(), -1)};
    for (std::size_t start = 0; start < mesh.triangles.size(); ++start) {
        if (found.parts[start] >= 0) continue;
        std::vector<std::size_t> waiting{start};
        found.parts[start] = found.count;
        while (!waiting.empty()) {
            const std::size_t here = waiting.back();
            waiting.pop_back();
            for (const auto& [next, is_opposite] : neighbours[here]) {
                const auto there = static_cast<std::size_t>(next);
                if (found.parts[there] >= 0) continue;
                found.parts[there] = found.count;
                found.is_turned[there] = static_cast<char>((found.is_turned[here] != 0) != is_opposite);
                waiting.push_back(there);
            }
        }
        ++found.count;
    }
    return found;
}

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
        const Vec3 a = find_area_vector(mesh, own[0].triangle);
        const Vec3 b =
            (own[0].goes_up == own[1].goes_up ? -1.0 : 1.0) * find_area_vector(mesh, own[1].triangle);
        const double turn = std::atan2(a.cross(b).norm(), a.dot(b));
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
    Orientation orientation = orient(mesh, sides);
    result.parts = static_cast<std::size_t>(orientation.count);
    find_flipped(mesh, orientation, result);
    measure_edges(mesh, sides, result);
    measure_triangles(mesh, orientation, result);
    find_holes(mesh, result);
    return result;
}

}  // namespace gxrod
