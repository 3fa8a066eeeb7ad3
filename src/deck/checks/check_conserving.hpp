#pragma once

#include "deck/places/build_context.hpp"

namespace gxrod {

// Adds a fault if the current stage uses energy-momentum and the model has something that the scheme does not
// cover. Call it after all actions of the stage are built.
void check_conserving(const BuildContext& context);

}  // namespace gxrod
