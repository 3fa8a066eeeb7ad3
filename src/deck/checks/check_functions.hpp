#pragma once

#include "deck/places/build_context.hpp"

namespace gxrod {

// Evaluates the functions of time in gravity, loads, supports and joints at the steps of the analysis (at
// 10001 of them, evenly spread, if there are more) and adds a fault for each value that is not finite. f(t,
// s) is evaluated at 101 of the steps and 101 points of the rod. Call it after build_rods and build_analysis.
void check_functions(const BuildContext& context);

}  // namespace gxrod
