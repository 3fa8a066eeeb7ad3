#pragma once

#include "rotation/types.hpp"

namespace gxrod {

// Memory of a piece of a rod that lies on the ground: the place to which friction pulls it back.
struct BedContact {
    double touches = 0.0;        // 1 or 0
    Vec3 target = Vec3::Zero();  // a place of the node
};

}  // namespace gxrod
