#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "contact/meshes/mesh_surface.hpp"
#include "contact/obstacle_distance.hpp"

namespace gxrod {

// A surface that a place touches at most once: a whole obstacle, or a surface of a mesh.
struct ObstacleSurface {
    const Obstacle* body = nullptr;
    std::size_t obstacle = 0;  // its index
    std::shared_ptr<const MeshSurface> mesh{};

    // Finds the distance of the centre of a ball, which feels the surface within a skin. Here and below a
    // memory spares searches in a mesh; results are the same without it.
    ObstacleDistance find_distance(const ObstaclePlacement& placement,
                                   const Vec3& point,
                                   double radius,
                                   double skin,
                                   MeshMemory* memory = nullptr) const;
    bool is_further(const ObstaclePlacement& placement,
                    const Vec3& point,
                    double distance,
                    MeshMemory* memory = nullptr) const;
    // Finds the free motion of a ball that moves straight while the obstacle goes from one placement to
    // another: 1 if it meets nothing. With a skin, the motion for a prediction.
    FreeMotion find_free_motion(double radius,
                                const ObstaclePlacement& from,
                                const Vec3& start,
                                const ObstaclePlacement& to,
                                const Vec3& end,
                                double skin = 0.0,
                                MeshMemory* memory = nullptr) const;
    // Finds the number in its file of a triangle that a straight line crosses.
    std::optional<int> find_crossed(const ObstaclePlacement& placement,
                                    const Vec3& start,
                                    const Vec3& end) const;
    // Names the triangle next to a point, "triangle 17 of "; "" if it is no mesh.
    std::string name_triangle(const ObstaclePlacement& placement, const Vec3& point) const;
};

// Lists the surfaces of all obstacles, which must outlive them.
std::vector<ObstacleSurface> list_surfaces(const std::vector<Obstacle>& obstacles);

}  // namespace gxrod
