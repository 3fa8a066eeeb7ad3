#pragma once

#include <map>
#include <utility>
#include <vector>

#include "model/obstacle_shape.hpp"

namespace gxrod {

// A triangle along an edge: whether it goes from the corner with the lower number to the other one.
struct EdgeSide {
    int triangle = 0;
    bool goes_up = false;
};
// The triangles at each edge, which is known by its corners, the lower number first.
using SidesOfEdges = std::map<std::pair<int, int>, std::vector<EdgeSide>>;
SidesOfEdges list_sides(const TriangleMesh& mesh);

// Which triangles are the other way around than the first of their part, and the part of each. Parts share no
// edge.
struct Orientation {
    std::vector<char> is_turned;
    std::vector<int> parts;
    int count = 0;
};
Orientation orient_triangles(const TriangleMesh& mesh, const SidesOfEdges& sides);

inline const Vec3& corner_at(const TriangleMesh& mesh, int corner) {
    return mesh.positions[static_cast<std::size_t>(corner)];
}

// Returns twice the area of a triangle, along the normal of its order of corners.
Vec3 find_area_vector(const TriangleMesh& mesh, int triangle);

// Returns by how much the surface turns at an edge with two triangles: 0 of a plane, π where it folds back.
double find_turn(const TriangleMesh& mesh, const std::vector<EdgeSide>& sides);

}  // namespace gxrod
