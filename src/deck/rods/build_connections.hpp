#pragma once

#include "deck/places/build_context.hpp"
#include "deck/rods/read_rod_nets.hpp"

namespace gxrod {

// Makes one node of the points that a [[connect]] names: removes nodes of rods that coincide with an earlier
// node, and renumbers the nodes of the model. `nets` has the rods from meshes. Call it after build_rods and
// before anything else that has nodes.
void build_connections(const RodNets& nets, BuildContext& context);

}  // namespace gxrod
