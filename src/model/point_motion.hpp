#pragma once

#include <functional>
#include <utility>

#include "rotation/types.hpp"

// Loads that depend on how the point on which they act moves.
namespace gxrod {

// How a point moves; all in global axes.
struct PointMotion {
    Vec3 position = Vec3::Zero();
    Vec3 velocity = Vec3::Zero();
    Vec3 rotation = Vec3::Zero();  // rotation vector since t = 0, of half a turn at most
    Vec3 spin = Vec3::Zero();      // angular velocity
};

// A number by time, arc length along a rod (0 at other points) and motion. Not for two threads at once.
using PointFunction = std::function<double(double time, double arc_length, const PointMotion& motion)>;

// A force by time, position and velocity. Not for two threads at once.
using MotionForce = std::function<Vec3(double time, const Vec3& position, const Vec3& velocity)>;

// A force and a moment, stacked, by time, arc length and motion; per length along rods. Not for two threads
// at once.
struct MotionLoad {
    std::function<Vec6(double time, double arc_length, const PointMotion& motion)> value{};  // or empty
    bool has_force = false;
    bool has_moment = false;
    bool turns = false;  // whether it depends on rotation or spin

    MotionLoad() = default;
    explicit MotionLoad(MotionForce force)
        : value([force = std::move(force)](double time, double, const PointMotion& motion) {
              Vec6 load = Vec6::Zero();
              load.head<3>() = force(time, motion.position, motion.velocity);
              return load;
          }),
          has_force(true) {}

    explicit operator bool() const { return static_cast<bool>(value); }
};

}  // namespace gxrod
