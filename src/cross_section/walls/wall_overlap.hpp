#pragma once

#include <optional>
#include <vector>

#include "cross_section/walls/wall_pieces.hpp"

namespace gxrod {

// Finds two pieces of a wall that cross each other, by their surfaces and middle lines; arcs as polygons.
std::optional<WallFault> find_wall_overlap(const std::vector<WallPiece>& pieces);

}  // namespace gxrod
