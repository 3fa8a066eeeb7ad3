#pragma once

#include "check/model_examination.hpp"

namespace gxrod {

// What a reader of a deck cannot see of waves, floating rods and the ground: waves too steep to be linear or
// to be there at all, elements and steps that do not resolve them, rods that sink deep into the ground.
std::vector<Finding> examine_surroundings(const Model& model, const AnalysisSettings& analysis);

}  // namespace gxrod
