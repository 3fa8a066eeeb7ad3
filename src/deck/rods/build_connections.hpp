#pragma once

#include "deck/places/build_context.hpp"

namespace gxrod {

// Makes one node of the points that a [[connect]] names: removes nodes of rods that coincide with an earlier
// node, and renumbers the nodes of the model. Call it after build_rods and before anything else that has
// nodes.
void build_connections(BuildContext& context);

}  // namespace gxrod
