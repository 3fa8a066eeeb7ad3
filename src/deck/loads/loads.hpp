#pragma once

#include "deck/places/build_context.hpp"

namespace gxrod {

// Adds gravity and the loads, at points and along rods, to the model. After build_bodies.
void build_loads(BuildContext& context);

// Sets the frame that turns, if the deck has one.
void build_rotation(BuildContext& context);

}  // namespace gxrod
