#pragma once

#include "deck/places/build_context.hpp"

namespace gxrod {

// What is wrong with what surrounds the model as a whole goes to the faults: that nothing takes part in it,
// or that there is nothing to take part in; that water has a surface and gravity does not act down on it.
void check_surroundings(const BuildContext& context);

}  // namespace gxrod
