#pragma once

#include "deck/places/build_context.hpp"

namespace gxrod {

// Adds the supports to the model, one per node. Call it after build_bodies.
void build_supports(BuildContext& context);
// Adds the springs to the ground by which supports yield. Call it after build_bodies.
void build_yielding_supports(BuildContext& context);

}  // namespace gxrod
