#pragma once

#include <memory>
#include <vector>

#include "contact/meshes/box_tree.hpp"
#include "contact/meshes/triangle_distance.hpp"
#include "contact/obstacle_distance.hpp"

namespace gxrod {

// Triangles of a mesh that act as one surface: smooth ones, or ones far from each other.
class MeshSurface {
  public:
    // Takes some triangles of a mesh, by their indices.
    MeshSurface(const TriangleMesh& mesh, std::vector<int> indices);

    // The closest point; its distance is `within` if none is nearer.
    struct Closest {
        ClosestOnTriangle point;
        int triangle = -1;  // index in the mesh
        int own = -1;       // index among the triangles of this surface
    };
    Closest find_closest(const Vec3& x, double within = std::numeric_limits<double>::infinity()) const;

    // Finds the distance of the centre of a ball of this radius. Beyond the skin it is the distance from the
    // closest point; within, the distance of a plane that is as near as all triangles together.
    ObstacleDistance find_distance(const Vec3& x, double radius, double skin) const;
    // Finds the free motion, as for obstacles of other shapes.
    FreeMotion find_free_motion(double radius, const Vec3& from, const Vec3& to, double skin = 0.0) const;
    // Finds the triangle that a straight line crosses, by its index in the mesh; −1 if there is none.
    int find_crossed(const Vec3& from, const Vec3& to) const;

  private:
    std::vector<int> indices_;
    std::vector<Triangle> triangles_;
    BoxTree tree_;
};

// Splits a mesh at sharp edges: each of its surfaces is smooth, or its parts are far from each other.
std::vector<std::shared_ptr<const MeshSurface>> split_at_sharp_edges(const TriangleMesh& mesh);

// Finds the spacing of a rod's places for which no edge or corner comes nearer between two of them than an
// eighth of the skin.
double find_mesh_spacing(const TriangleMesh& mesh, double radius, double skin);

}  // namespace gxrod
