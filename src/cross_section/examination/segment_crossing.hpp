#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "cross_section/section_mesh.hpp"

namespace gxrod {

struct PlaneSegment {
    PlanePoint from, to;
    int owner = 0;  // whose it is, such as a side of a wall or a cell
};

// Returns the point within both segments, away from their ends, at which they cross.
std::optional<PlanePoint> find_crossing(const PlaneSegment& a, const PlaneSegment& b);

struct SegmentCrossing {
    PlaneSegment a, b;
    PlanePoint at;
};

// Finds two of many segments that cross.
std::optional<SegmentCrossing> find_crossing(std::vector<PlaneSegment> segments);

}  // namespace gxrod
