#pragma once

#include "deck/places/build_context.hpp"

// Joints, gears and sleeves, which are joints of type "sleeve".
namespace gxrod {

// Builds the joints of a deck without motors, springs and friction. Call it after build_bodies.
void build_joints(BuildContext& context);
// Builds motors, springs, friction and limits of joints as they act in the current stage. Call it after
// build_supports.
void build_joint_actions(BuildContext& context);

// Builds the gears of a deck. Call it after build_joints.
void build_gears(BuildContext& context);

// Adds the sleeves to the model, which has its rods.
void build_sleeves(BuildContext& context);
// Builds the actions on them in the current stage.
void build_sleeve_actions(BuildContext& context);

}  // namespace gxrod
