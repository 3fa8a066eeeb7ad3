#pragma once

#include "deck/places/build_context.hpp"

namespace gxrod {

// Checks that the initial velocities of supported nodes are those that their supports allow: none along fixed
// components, the rate of f(t) along moved ones. Takes round-off off the former. After build_initial and
// build_supports.
void check_velocities(BuildContext& context);

}  // namespace gxrod
