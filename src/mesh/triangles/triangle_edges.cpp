#include "mesh/triangles/triangle_edges.hpp"

#include <algorithm>
#include <cmath>

namespace gxrod {

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

Vec3 find_area_vector(const TriangleMesh& mesh, int triangle) {
    const auto& [a, b, c] = mesh.triangles[static_cast<std::size_t>(triangle)];
    return (corner_at(mesh, b) - corner_at(mesh, a)).cross(corner_at(mesh, c) - corner_at(mesh, a));
}

Orientation orient_triangles(const TriangleMesh& mesh, const SidesOfEdges& sides) {
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

double find_turn(const TriangleMesh& mesh, const std::vector<EdgeSide>& sides) {
    const Vec3 a = find_area_vector(mesh, sides[0].triangle);
    const double sign = sides[0].goes_up == sides[1].goes_up ? -1.0 : 1.0;
    const Vec3 b = sign * find_area_vector(mesh, sides[1].triangle);
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

}  // namespace gxrod
