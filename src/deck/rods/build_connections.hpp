#pragma once

#include "deck/places/build_context.hpp"

namespace gxrod {

// Makes one node of the points that a [[connect]] names: nodes of the model are renumbered, and those of rods
// that become one with an earlier one are gone. After build_rods and before anything else that has nodes.
void build_connections(BuildContext& context);

}  // namespace gxrod
