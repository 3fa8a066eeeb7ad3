#pragma once

#include "deck/places/build_context.hpp"

namespace gxrod {

// Adds the tendons, actuations and magnetic rods to the model, as they act in the current stage. Call it
// after build_loads, as a magnetic rod is a load. Tendons that do not pull in the stage have a tension of 0,
// or a winch that has let go.
void build_drives(BuildContext& context);

}  // namespace gxrod
