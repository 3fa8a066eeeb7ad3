#pragma once

#include "state/motion.hpp"

namespace gxrod {

// Water, air and ground around a point of a rod, or a body; spatial. Zero without surroundings.
struct PointSurroundings {
    Vec3 water_velocity = Vec3::Zero();
    double wet_fraction = 0.0;
    Vec3 fluid_force = Vec3::Zero();  // from water and air, per length of a rod
    Vec3 bed_force = Vec3::Zero();    // per length of a rod
    // p_i A_i − p_o A_o, from the contents of a rod and the water outside: its wall carries N + this.
    double pressure_force = 0.0;
};

// A point of a rod, at a node or between.
struct PointValues {
    // Interpolated between nodes as `objective` elements do; theta and alpha are left out.
    NodeMotion motion;
    Vec3 start = Vec3::Zero();      // position at t = 0
    Quat triad = Quat::Identity();  // section axes at t = 0; now motion.Lambda * triad
    // In the section axes.
    Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
    Vec3 strain = Vec3::Zero(), curvature = Vec3::Zero();
    PointSurroundings surroundings;
};

}  // namespace gxrod
