#pragma once

#include "contact/pairs/closest_points.hpp"

namespace gxrod {

// Which ends of two segments are not ends of their lines, but go on there.
struct OpenEnds {
    bool a_start = false, a_end = false, b_start = false, b_end = false;
};

// Where two segments of longer lines touch, as if they went on straight at open ends: the closest points,
// moved along both until the offset is at right angles to them. So places and normals of lines that slide
// along each other are continuous, whichever pieces of them are near. Along lines that are nearly parallel no
// place is the closest: `crossing` falls to nothing, and the offset is at right angles to what is common.
struct OpenContact {
    ClosestPoints inside;        // of the segments themselves
    double s = 0.0, t = 0.0;     // below 0 or above 1 beyond the segments
    Vec3 offset = Vec3::Zero();  // from the point of the second line to that of the first
    double crossing = 0.0;       // 1 at a right angle
    // Derivatives by the four ends.
    Vec12 s_by = Vec12::Zero(), t_by = Vec12::Zero(), crossing_by = Vec12::Zero();
    Mat312 offset_by = Mat312::Zero();
};
OpenContact find_open_contact(const Segment& a, const Segment& b, const OpenEnds& open);

}  // namespace gxrod
