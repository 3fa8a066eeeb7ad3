#pragma once

#include <optional>

#include "deck/places/build_context.hpp"
#include "geometry/centreline.hpp"

namespace gxrod {

// The centreline that the line, arc, helix, polyline, spline or catenary of a table describes: of a rod, or
// of its rest. What is wrong with it goes to the faults, and nullopt comes back.
std::optional<Centreline> find_centreline(const CheckedTable& shape,
                                          const CheckedTable& rod,
                                          const BuildContext& context);

}  // namespace gxrod
