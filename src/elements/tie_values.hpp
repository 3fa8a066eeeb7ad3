#pragma once

#include <span>
#include <vector>

#include "model/model.hpp"
#include "state/motion.hpp"
#include "state/values/bushing_values.hpp"
#include "state/values/spring_values.hpp"

namespace gxrod {

// The values of all springs at the motions of all nodes, in the order of Model::springs.
std::vector<SpringValues> compute_spring_values(const Model& model, std::span<const NodeMotion> nodes);
// The values of all bushings, in the order of Model::bushings.
std::vector<BushingValues> compute_bushing_values(const Model& model, std::span<const NodeMotion> nodes);

}  // namespace gxrod
