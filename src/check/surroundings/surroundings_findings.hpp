#pragma once

#include "check/model_examination.hpp"

namespace gxrod {

// Finds problems of waves, floating rods and the ground that a deck does not show: waves too steep to be
// linear or to exist, elements and steps that do not resolve them, rods that sink deep into the ground.
std::vector<Finding> examine_surroundings(const Model& model, const AnalysisSettings& analysis);

}  // namespace gxrod
