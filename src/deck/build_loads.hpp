#pragma once

#include "deck/build_context.hpp"
#include "model/settings.hpp"

namespace gxrod {

// Adds the loads to the model. After build_bodies.
void build_loads(BuildContext& context);

// Evaluates every f(t) of the loads at the steps of the analysis (10001 of them, evenly spread, if there are
// more) and adds a fault for each that has no finite value somewhere.
void check_load_functions(const DynamicSettings& analysis, BuildContext& context);

}  // namespace gxrod
