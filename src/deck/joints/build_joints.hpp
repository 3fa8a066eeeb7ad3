#pragma once

#include "deck/places/build_context.hpp"

namespace gxrod {

// The joints of a deck, without what acts on them. After build_bodies.
void build_joints(BuildContext& context);

// What acts on them in the stage at hand. After build_supports.
void build_joint_actions(BuildContext& context);

}  // namespace gxrod
