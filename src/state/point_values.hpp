#pragma once

#include "state/motion.hpp"

namespace gxrod {

// A point of a rod, at a node or between.
struct PointValues {
    // Between nodes interpolated as `objective` elements do; theta and alpha are left out.
    NodeMotion motion;
    Vec3 start;  // where it was at t = 0
    Quat triad;  // section axes at t = 0; now motion.Lambda * triad
    // In the section axes.
    Vec3 force, moment;
    Vec3 strain, curvature;
};

}  // namespace gxrod
