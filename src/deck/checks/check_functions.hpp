#pragma once

#include "deck/places/build_context.hpp"

namespace gxrod {

// Evaluates what changes with time in gravity, loads, supports and joints at the steps of the analysis (10001
// of them, evenly spread, if there are more) and adds a fault for each value that is not finite somewhere.
// f(t, s) is asked for at 101 of the steps, each at 101 points of the rod. After build_rods and
// build_analysis.
void check_functions(const BuildContext& context);

}  // namespace gxrod
