#pragma once

#include <string>
#include <vector>

#include "model/model.hpp"
#include "model/parts.hpp"

namespace gxrod {

// A sentence for each part in which round-off of the forces in one rod comes near the forces that bend
// another, or the rod itself: where equilibrium is asked for, Newton's method finds it in many steps, or what
// it takes for it is none.
std::vector<std::string> find_stiffness_contrasts(const Model& model, const std::vector<ModelPart>& parts);

}  // namespace gxrod
