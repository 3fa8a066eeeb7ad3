#pragma once

#include "deck/build_context.hpp"

namespace gxrod {

// Adds the supports to the model, one a node, and checks that bodies do not start with a velocity that a
// support holds. After build_bodies.
void build_supports(BuildContext& context);

}  // namespace gxrod
