#pragma once

#include "cross_section/outlines/outline.hpp"

namespace gxrod {

// Finds what is wrong with a polygon: too few or repeated corners, radii that do not fit, an outline that
// crosses itself, holes that are not inside or not apart. Parts are counted from 0: "outer[3]",
// "holes[0][2]". Without a fault it can be drawn and meshed.
std::optional<OutlineFault> find_fault(const Polygon& polygon);

}  // namespace gxrod
