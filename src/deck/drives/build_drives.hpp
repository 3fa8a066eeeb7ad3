#pragma once

#include "deck/places/build_context.hpp"

// Adds what acts from inside to the model, as it acts in the current stage.
namespace gxrod {

// Tendons and chambers. Those that do not act in the stage have a tension of 0, or a winch that has let go.
void build_tendons(BuildContext& context);
void build_actuations(BuildContext& context);
// Call it after build_loads, as a magnetic rod is a load.
void build_magnets(BuildContext& context);

}  // namespace gxrod
