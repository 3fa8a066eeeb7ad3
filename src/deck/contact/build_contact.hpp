#pragma once

#include "deck/places/build_context.hpp"

namespace gxrod {

// Adds contact to the model: obstacles, their motions in the current stage, and pairs of rods. Call it after
// build_rods.
void build_contact(BuildContext& context);

// Adds faults for analyses that do not support contact. Call it after choose_schemes.
void check_contact(const BuildContext& context);

}  // namespace gxrod
