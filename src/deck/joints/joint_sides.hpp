#pragma once

#include "deck/places/build_context.hpp"

namespace gxrod {

// The points and axes of the sides of a [joint.NAME], into `joint`, which has its kind. Returns whether it
// has them; where not, there is a fault or a point without a node. `size` is that of the model.
bool place_joint(const CheckedTable& table, double size, Joint& joint, const BuildContext& context);

}  // namespace gxrod
