#pragma once

#include <memory>
#include <vector>

#include "contact/meshes/box_tree.hpp"
#include "contact/meshes/mesh_memory.hpp"
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
    Closest find_closest(const Vec3& x,
                         double within = std::numeric_limits<double>::infinity(),
                         MeshMemory* memory = nullptr) const;
    // Returns the least distance, at most `within`.
    double find_least(const Vec3& x, double within, MeshMemory* memory = nullptr) const;
    // Whether a point is nearer than a distance.
    bool is_nearer(const Vec3& x, double distance, MeshMemory* memory = nullptr) const;

    // Finds the distance of the centre of a ball of this radius. Beyond the skin it is the distance from the
    // closest point; within, the distance of a plane that is as near as all triangles together.
    // A memory must always be asked for the same radius and skin.
    ObstacleDistance find_distance(const Vec3& x,
                                   double radius,
                                   double skin,
                                   MeshMemory* memory = nullptr) const;
    // Finds the free motion, as for obstacles of other shapes.
    FreeMotion find_free_motion(double radius,
                                const Vec3& from,
                                const Vec3& to,
                                double skin = 0.0,
                                MeshMemory* memory = nullptr) const;
    // Finds the triangle that a straight line crosses, by its index in the mesh; −1 if there is none.
    int find_crossed(const Vec3& from, const Vec3& to) const;

  private:
    double rounding_at(const Vec3& x) const { return rounding_ * std::max(extent_, x.cwiseAbs().maxCoeff()); }
    ClosestOnTriangle find_on(int triangle, const Vec3& x) const {
        return find_on_triangle(triangles_[static_cast<std::size_t>(triangle)], x);
    }
    Closest search(const Vec3& x, double within) const;
    Closest search_with(const Vec3& x, MeshMemory& memory) const;
    int find_nearby(const Vec3& x, const MeshMemory& memory) const;
    ObstacleDistance find_distance_from(
        const Closest& closest, const Vec3& x, double radius, double skin, const MeshMemory* memory) const;
    // Calls visit(triangle) for each triangle whose box meets this one, in the order of the tree.
    template <class Visit>
    void visit_meeting(const Box& box, const MeshMemory* memory, const Visit& visit) const;

    // Bounds the rounding of distances, relative to coordinates.
    static constexpr double rounding_ = 1e-13;

    std::vector<int> indices_;
    std::vector<Triangle> triangles_;
    std::vector<Box> boxes_;
    double extent_ = 0.0;  // largest coordinate
    BoxTree tree_;
};

// Splits a mesh at sharp edges: each of its surfaces is smooth, or its parts are far from each other.
std::vector<std::shared_ptr<const MeshSurface>> split_at_sharp_edges(const TriangleMesh& mesh);

// Finds the spacing of a rod's places for which no edge or corner comes nearer between two of them than an
// eighth of the skin.
double find_mesh_spacing(const TriangleMesh& mesh, double radius, double skin);

}  // namespace gxrod
