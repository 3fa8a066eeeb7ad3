#pragma once

#include "deck/places/build_context.hpp"
#include "deck/surroundings/surroundings_files.hpp"

namespace gxrod {

// Gives the model its surroundings in the current stage. Call it after build_bodies.
void build_surroundings(const SurroundingsFiles& files, BuildContext& context);

}  // namespace gxrod
