#pragma once

#include <array>
#include <memory>
#include <vector>

#include "contact/meshes/box_tree.hpp"
#include "contact/obstacle_distance.hpp"

namespace gxrod {

// Remembers what was last found of a mesh's surface around one point that moves, so that most questions need
// no search. Answers are the same with it and without, to the last bit. One thread at a time may use it.
struct MeshMemory {
    // The triangles whose boxes meet a box around the point, and the last distances within it.
    struct Nearby {
        struct Found {
            Vec3 at = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
            ObstacleDistance distance{};
        };

        Box box{};
        std::vector<int> triangles;  // in the order of the tree
        std::array<Found, 2> found{};
        std::size_t oldest = 0;

        // Returns how far from a point the box reaches on all sides; negative outside of it.
        double reach_from(const Vec3& x) const { return (x - box.low).cwiseMin(box.high - x).minCoeff(); }
    };

    // The distance of a point: that of another point differs by no more than the way between both.
    Vec3 at = Vec3::Zero();
    double distance = -1.0;  // negative: unknown
    double range = 0.0;      // up to twice this distance triangles are remembered
    std::unique_ptr<Nearby> nearby{};
};

}  // namespace gxrod
