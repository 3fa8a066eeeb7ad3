#pragma once

#include "deck/places/build_context.hpp"

namespace gxrod {

// Adds the sleeves, joints of type "sleeve", to the model, which has its rods.
void build_sleeves(BuildContext& context);

// Builds the actions on them in the current stage.
void build_sleeve_actions(BuildContext& context);

}  // namespace gxrod
