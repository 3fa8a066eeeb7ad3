#pragma once

#include "rotation/types.hpp"

namespace gxrod {

// Values of an obstacle at a step that histories record.
struct ObstacleValues {
    Vec3 force = Vec3::Zero();     // force of rods on it
    Vec3 friction = Vec3::Zero();  // the part of it along its surface
    double least_gap = 0.0;        // to the surface of a rod; negative where a bed is pressed in
};

}  // namespace gxrod
