#pragma once

#include "deck/places/build_context.hpp"

namespace gxrod {

// A fault where the stage at hand asks for energy-momentum, and its model has what that scheme does not
// cover. After what acts in the stage is built.
void check_conserving(const BuildContext& context);

}  // namespace gxrod
