#pragma once

#include <memory>
#include <vector>

#include "contact/meshes/box_tree.hpp"
#include "contact/meshes/triangle_distance.hpp"
#include "contact/obstacle_distance.hpp"

namespace gxrod {

// Triangles of a mesh that are touched as one surface: smooth ones, or far from each other.
class MeshSurface {
  public:
    // Some triangles of a mesh, by their indices.
    MeshSurface(const TriangleMesh& mesh, std::vector<int> indices);

    // The closest point; its distance is `within` if none is nearer.
    struct Closest {
        ClosestOnTriangle point;
        int triangle = -1;  // index in the mesh
        int own = -1;       // among those of this surface
    };
    Closest find_closest(const Vec3& x, double within = std::numeric_limits<double>::infinity()) const;

    // Of the centre of a ball of this radius. Beyond the skin it is the distance from the closest point;
    // within, what a plane would have that is as near as all triangles together.
    ObstacleDistance find_distance(const Vec3& x, double radius, double skin) const;
    // As for obstacles of other shapes.
    FreeMotion find_free_motion(double radius, const Vec3& from, const Vec3& to, double skin = 0.0) const;
    // The triangle that a straight line crosses, by its index in the mesh; −1 if there is none.
    int find_crossed(const Vec3& from, const Vec3& to) const;

  private:
    std::vector<int> indices_;
    std::vector<Triangle> triangles_;
    BoxTree tree_;
};

// Sharp edges part a mesh: each of its surfaces is smooth but for where its parts are far from each other.
std::vector<std::shared_ptr<const MeshSurface>> split_at_sharp_edges(const TriangleMesh& mesh);

// How close together places of a rod are to be, so that no edge or corner gets nearer between two of them
// than an eighth of the skin.
double find_mesh_spacing(const TriangleMesh& mesh, double radius, double skin);

}  // namespace gxrod
