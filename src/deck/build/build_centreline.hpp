#pragma once

#include <optional>

#include "deck/build/build_context.hpp"
#include "geometry/centreline.hpp"

namespace gxrod {

// The centreline that a rod's line, arc, helix, polyline or spline describes. What is wrong with it goes to
// the faults, and nullopt comes back.
std::optional<Centreline> find_centreline(const CheckedTable& rod, const BuildContext& context);

}  // namespace gxrod
