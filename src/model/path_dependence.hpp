#pragma once

#include "model/model.hpp"

namespace gxrod {

// Whether an equilibrium depends on how it was reached: by what sections remember, by friction, or by
// elements that measure rotations from the step before.
bool depends_on_path(const Model& model);

}  // namespace gxrod
