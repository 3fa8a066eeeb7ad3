#pragma once

#include <vector>

#include "check/model_examination.hpp"

namespace gxrod {

// What a reader of a deck cannot see of contact at the start of its first stage: what overlaps, what touches
// already, what is left out at joints, elements too long for their bends, steps too long for their speeds.
std::vector<Finding> examine_contact(const Model& model, const AnalysisSettings& analysis);

}  // namespace gxrod
