#pragma once

#include "deck/places/build_context.hpp"

namespace gxrod {

// Builds the joints of a deck without motors, springs and friction. Call it after build_bodies.
void build_joints(BuildContext& context);

// Builds motors, springs, friction and limits of joints as they act in the current stage. Call it after
// build_supports.
void build_joint_actions(BuildContext& context);

}  // namespace gxrod
