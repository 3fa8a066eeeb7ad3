#pragma once

#include "deck/places/build_context.hpp"

namespace gxrod {

// Adds to the model what contents that flow through rods exert on them in the current stage: a pull of
// −m v² in the sections with thrusts at the ends, which together are −m v² κ, and −2 m v ω × t and −m v̇ t
// along the rods (docs/theory/water.md). Call it after build_loads and build_actuations.
void build_contents_flow(BuildContext& context);

}  // namespace gxrod
