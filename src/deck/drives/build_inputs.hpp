#pragma once

#include "deck/places/build_context.hpp"

namespace gxrod {

// Gives the inputs that the deck's expressions read the course of their [input.NAME].
void build_inputs(BuildContext& context);

}  // namespace gxrod
