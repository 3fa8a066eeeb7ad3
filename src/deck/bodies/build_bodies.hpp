#pragma once

#include "deck/places/build_context.hpp"

namespace gxrod {

// Adds the bodies to the model, with nodes for those that are not on a rod, and their velocities to their
// nodes. After build_rods.
void build_bodies(BuildContext& context);

}  // namespace gxrod
