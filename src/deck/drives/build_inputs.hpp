#pragma once

#include "deck/places/build_context.hpp"

namespace gxrod {

// Gives the inputs in the deck's expressions the course of their [input.NAME].
void build_inputs(BuildContext& context);

}  // namespace gxrod
