#pragma once

#include "deck/places/build_context.hpp"

namespace gxrod {

// The gears of a deck. After build_joints.
void build_gears(BuildContext& context);

}  // namespace gxrod
