#pragma once

#include "model/contact.hpp"

namespace gxrod {

// The distance of a point from the surface of an obstacle, positive on the side of the rods.
struct ObstacleDistance {
    double distance = 0.0;
    Vec3 normal = Vec3::Zero();     // along its gradient, of length 1
    double slope = 1.0;             // the length of its gradient
    Mat3 curvature = Mat3::Zero();  // its second derivative, symmetric
    Vec3 position = Vec3::Zero();   // closest point on the obstacle's line
};
// Finds the distance from an obstacle at its place at t = 0. On the line of a tube, where no direction is
// closest, the normal is zero.
ObstacleDistance find_obstacle_distance(const Obstacle& obstacle, const Vec3& point);

// The place of an obstacle: x = turn (x₀ − about) + about + displacement for its points x₀ at t = 0.
struct ObstaclePlacement {
    Vec3 displacement = Vec3::Zero();
    Vec3 rotation = Vec3::Zero();
    Vec3 about = Vec3::Zero();
    Mat3 turn = Mat3::Identity();

    Vec3 to_start(const Vec3& x) const { return turn.transpose() * (x - about - displacement) + about; }
    Vec3 from_start(const Vec3& x) const { return turn * (x - about) + about + displacement; }
};
ObstaclePlacement place_obstacle(const Obstacle& obstacle, double time);
// Interpolates between two placements: displacements and rotation vectors are linear.
ObstaclePlacement between(const ObstaclePlacement& from, const ObstaclePlacement& to, double fraction);
// Finds the distance from a moved obstacle.
ObstacleDistance find_obstacle_distance(const Obstacle& obstacle,
                                        const ObstaclePlacement& placement,
                                        const Vec3& point);

// The largest part of the straight motion of a point, in the axes of the obstacle, after which its distance
// above `radius` is still a tenth of its value at the start, or a little more; 1 if the whole motion is free.
// With a skin, the part for a prediction (find_predicted_share).
struct FreeMotion {
    double fraction = 1.0;
    double gap = 0.0;  // at the start
};
FreeMotion find_free_motion(
    const Obstacle& obstacle, double radius, const Vec3& from, const Vec3& to, double skin = 0.0);

}  // namespace gxrod
