#pragma once

#include "deck/places/build_context.hpp"

namespace gxrod {

// Adds the supports to the model, one a node. After build_bodies.
void build_supports(BuildContext& context);

}  // namespace gxrod
