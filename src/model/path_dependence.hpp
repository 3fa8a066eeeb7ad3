#pragma once

#include "model/model.hpp"

namespace gxrod {

// Whether an equilibrium depends on its history: by memory of sections, by friction, or by elements that
// measure rotations from the previous step.
bool depends_on_path(const Model& model);

}  // namespace gxrod
