#pragma once

#include "deck/places/build_context.hpp"

namespace gxrod {

// Adds faults of the surroundings as a whole: nothing in the model takes part in them, or there are none to
// take part in; water has a surface and gravity does not act down on it.
void check_surroundings(const BuildContext& context);

}  // namespace gxrod
