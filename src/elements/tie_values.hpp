#pragma once

#include <span>

#include "model/model.hpp"
#include "state/motion.hpp"
#include "state/values/tie_values.hpp"

namespace gxrod {

// Computes the values of springs and bushings at the motions of all nodes.
TieValues compute_tie_values(const Model& model, std::span<const NodeMotion> nodes);

}  // namespace gxrod
