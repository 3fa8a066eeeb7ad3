#pragma once

#include "deck/places/build_context.hpp"

namespace gxrod {

// Checks every text of the deck that names a point, and returns the points of rods.
std::vector<RodPoint> check_points(const BuildContext& context);

}  // namespace gxrod
