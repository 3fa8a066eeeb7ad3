#pragma once

#include "rotation/types.hpp"

namespace gxrod {

// Values of a bushing at a step that histories record, in its axes.
struct BushingValues {
    Mat3 axes = Mat3::Identity();  // spatial: columns are x, y, z
    Vec3 displacement = Vec3::Zero();
    Vec3 turn = Vec3::Zero();
    Vec3 force = Vec3::Zero();  // force of B on it
    Vec3 moment = Vec3::Zero();
};

}  // namespace gxrod
