#pragma once

#include <optional>

#include "cross_section/outlines/outline.hpp"

namespace gxrod {

// Finds a point at which two pieces cross or touch within a distance. Pieces that follow each other share an
// end, `shared`, which does not count.
std::optional<PlanePoint> find_contact(const OutlinePiece& a,
                                       const OutlinePiece& b,
                                       double within,
                                       const PlanePoint* shared = nullptr);

// Returns whether a point, not on a loop, is inside it.
bool is_inside(const OutlineLoop& loop, const PlanePoint& point);

}  // namespace gxrod
