#pragma once

#include "deck/places/build_context.hpp"

namespace gxrod {

// Sets the points and axes of both sides of a [joint.NAME] in `joint`, which has its kind. Returns whether it
// could; if not, there is a fault or a point without a node. `size` is the size of the model.
bool place_joint(const CheckedTable& table, double size, Joint& joint, const BuildContext& context);

}  // namespace gxrod
