#pragma once

#include <array>
#include <vector>

#include "model/model.hpp"

namespace gxrod {

// Which of a node's components x y z rx ry rz a support holds.
using FixedComponents = std::array<bool, 6>;

// Per node of the model. Supports of one node add up. A held spin component keeps the rotation about that
// global axis at zero when all three are held, and leaves a hinge about the third axis when two are.
std::vector<FixedComponents> compute_fixed_components(const Model& model);

}  // namespace gxrod
