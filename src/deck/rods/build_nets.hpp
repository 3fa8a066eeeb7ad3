#pragma once

#include "deck/places/build_context.hpp"
#include "deck/rods/read_rod_nets.hpp"
#include "deck/rods/rod_table.hpp"

namespace gxrod {

// Checks that the table of a rod from a mesh has no key that the mesh decides.
void check_meshed_rod(const RodTable& table, const BuildContext& context);

// Adds the nodes and elements of a rod from a mesh.
void build_net(const RodTable& table, const NamedNet& net, int index, BuildContext& context);

}  // namespace gxrod
