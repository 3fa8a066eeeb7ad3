#include "contact/obstacle_surface.hpp"

#include <algorithm>
#include <cmath>

namespace gxrod {
namespace {

ObstacleDistance turn_back(const ObstaclePlacement& placement, ObstacleDistance distance) {
    const Mat3& Q = placement.turn;
    distance.normal = Q * distance.normal;
    distance.curvature = Q * distance.curvature * Q.transpose();
    distance.position = placement.from_start(distance.position);
    return distance;
}

// Of the motion of a point in the axes of an obstacle that turns: no less than its second derivative, by the
// part of the way gone.
double bound_bend(const ObstaclePlacement& from,
                  const Vec3& start,
                  const ObstaclePlacement& to,
                  const Vec3& end) {
    const double turn = (to.rotation - from.rotation).norm();
    if (turn == 0.0) return 0.0;
    const Vec3 arm = start - from.about - from.displacement;
    const Vec3 last_arm = end - to.about - to.displacement;
    return 2.0 * turn * turn * std::max(arm.norm(), last_arm.norm()) + 2.0 * turn * (last_arm - arm).norm();
}

}  // namespace

ObstacleDistance ObstacleSurface::find_distance(const ObstaclePlacement& placement,
                                                const Vec3& point,
                                                double radius,
                                                double skin,
                                                MeshMemory* memory) const {
    if (!mesh) return find_obstacle_distance(*body, placement, point);
    if (!body->motion) return mesh->find_distance(point, radius, skin, memory);
    return turn_back(placement, mesh->find_distance(placement.to_start(point), radius, skin, memory));
}

bool ObstacleSurface::is_further(const ObstaclePlacement& placement,
                                 const Vec3& point,
                                 double distance,
                                 MeshMemory* memory) const {
    if (!mesh) return find_obstacle_distance(*body, placement, point).distance > distance;
    const Vec3 x = body->motion ? placement.to_start(point) : point;
    return !mesh->is_nearer(x, distance, memory);
}

FreeMotion ObstacleSurface::find_free_motion(double radius,
                                             const ObstaclePlacement& from,
                                             const Vec3& start,
                                             const ObstaclePlacement& to,
                                             const Vec3& end,
                                             double skin,
                                             MeshMemory* memory) const {
    if (!mesh) return gxrod::find_free_motion(*body, radius, from.to_start(start), to.to_start(end), skin);
    if (!body->motion) return mesh->find_free_motion(radius, start, end, skin, memory);
    const Vec3 x = from.to_start(start);
    const double bend = bound_bend(from, start, to, end);
    if (bend == 0.0) return mesh->find_free_motion(radius, x, to.to_start(end), skin, memory);
    // A way that bends leaves its chord by an eighth of that at most: as much of it as keeps that below a
    // quarter of the gap.
    const double reach = (end - start).norm() + (to.displacement - from.displacement).norm() + bend;
    const double gap = mesh->find_least(x, radius + 2.0 * reach, memory) - radius;
    if (gap >= 2.0 * reach) return {1.0, gap};
    if (!(gap > 0.0)) return {0.0, gap};
    const double part = std::min(1.0, std::sqrt(2.0 * gap / bend));
    const ObstaclePlacement there = between(from, to, part);
    const double aside = part * part * bend / 8.0;
    const FreeMotion free =
        mesh->find_free_motion(radius + aside, x, there.to_start(start + part * (end - start)), 0.0, memory);
    return {part * free.fraction, gap};
}

std::optional<int> ObstacleSurface::find_crossed(const ObstaclePlacement& placement,
                                                 const Vec3& start,
                                                 const Vec3& end) const {
    if (!mesh) return std::nullopt;
    const int crossed = mesh->find_crossed(placement.to_start(start), placement.to_start(end));
    return crossed < 0 ? std::nullopt
                       : std::optional(body->mesh()->numbers[static_cast<std::size_t>(crossed)]);
}

std::string ObstacleSurface::name_triangle(const ObstaclePlacement& placement, const Vec3& point) const {
    if (!mesh) return "";
    const int nearest = mesh->find_closest(placement.to_start(point)).triangle;
    return "triangle " + std::to_string(body->mesh()->numbers[static_cast<std::size_t>(nearest)]) + " of ";
}

std::vector<ObstacleSurface> list_surfaces(const std::vector<Obstacle>& obstacles) {
    std::vector<ObstacleSurface> surfaces;
    for (std::size_t i = 0; i < obstacles.size(); ++i) {
        const TriangleMesh* mesh = obstacles[i].mesh();
        if (mesh == nullptr) {
            surfaces.push_back({&obstacles[i], i});
            continue;
        }
        for (const auto& part : split_at_sharp_edges(*mesh)) surfaces.push_back({&obstacles[i], i, part});
    }
    return surfaces;
}

}  // namespace gxrod
