#pragma once

#include "contact/pairs/closest_points.hpp"

namespace gxrod {

// The ends of two segments at which their lines continue.
struct OpenEnds {
    bool a_start = false, a_end = false, b_start = false, b_end = false;
};

// The contact of two segments of longer lines, continued straight at open ends: the closest points, moved
// along both until the offset is at right angles to both lines. Places and normals of lines that slide along
// each other are thus continuous, whichever pieces of them are near. Nearly parallel lines have no unique
// closest place: `crossing` falls to zero, and the offset is at right angles to their common direction.
struct OpenContact {
    ClosestPoints inside;        // closest points of the segments themselves
    double s = 0.0, t = 0.0;     // below 0 or above 1 beyond the segments
    Vec3 offset = Vec3::Zero();  // from the second line's point to the first's
    double crossing = 0.0;       // 1 at a right angle
    // Derivatives by the four ends.
    Vec12 s_by = Vec12::Zero(), t_by = Vec12::Zero(), crossing_by = Vec12::Zero();
    Mat312 offset_by = Mat312::Zero();
};
OpenContact find_open_contact(const Segment& a, const Segment& b, const OpenEnds& open);

}  // namespace gxrod
