#pragma once

#include "deck/places/build_context.hpp"

namespace gxrod {

// Gives the nodes the velocities of [[initial]]. After build_bodies.
void build_initial(BuildContext& context);

}  // namespace gxrod
