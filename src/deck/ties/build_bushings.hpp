#pragma once

#include "deck/places/build_context.hpp"

namespace gxrod {

// After build_bodies.
void build_bushings(BuildContext& context);

}  // namespace gxrod
