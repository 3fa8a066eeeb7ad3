#pragma once

#include <optional>

#include "deck/places/build_context.hpp"
#include "geometry/centreline.hpp"

namespace gxrod {

// Finds the centreline of a rod, or of its rest shape, from the line, arc, helix, polyline, spline or
// catenary of a table. If that is wrong, adds a fault and returns nullopt.
std::optional<Centreline> find_centreline(const CheckedTable& shape,
                                          const CheckedTable& rod,
                                          const BuildContext& context);

}  // namespace gxrod
