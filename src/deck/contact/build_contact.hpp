#pragma once

#include "deck/places/build_context.hpp"

namespace gxrod {

// Gives the model what its rods touch, and how that moves in the stage at hand. After build_rods.
void build_contact(BuildContext& context);

// Reports analyses that contact does not go with. After choose_schemes.
void check_contact(const BuildContext& context);

}  // namespace gxrod
