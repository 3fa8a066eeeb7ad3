#pragma once

#include "rotation/types.hpp"

namespace gxrod {

// Section forces and strains at the middle of one element, material axes.
struct SectionValues {
    Vec3 force, moment;
    Vec3 strain, curvature;
    Quat axes;  // section axes there: columns are x, y, z
};

}  // namespace gxrod
