#pragma once

#include "deck/places/build_context.hpp"

namespace gxrod {

// Checks that supports allow the initial velocities of their nodes: none along fixed components, where
// round-off is removed, and the rate of f(t) along moved ones. Call it after build_initial and
// build_supports.
void check_velocities(BuildContext& context);

}  // namespace gxrod
