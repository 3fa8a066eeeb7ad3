#pragma once

#include "rotation/types.hpp"

namespace gxrod {

// What a piece of a rod remembers of the ground it lies on: to where friction pulls it back.
struct BedContact {
    double touches = 0.0;        // 1 or 0
    Vec3 target = Vec3::Zero();  // a place of the node
};

}  // namespace gxrod
