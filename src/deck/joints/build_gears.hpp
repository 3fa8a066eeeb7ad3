#pragma once

#include "deck/places/build_context.hpp"

namespace gxrod {

// Builds the gears of a deck. Call it after build_joints.
void build_gears(BuildContext& context);

}  // namespace gxrod
