#pragma once

#include "deck/places/build_context.hpp"

namespace gxrod {

// Adds the sleeves, joints of type "sleeve", to the model, which has its rods.
void build_sleeves(BuildContext& context);

// What acts on them in the stage at hand.
void build_sleeve_actions(BuildContext& context);

}  // namespace gxrod
