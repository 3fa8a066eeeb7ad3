#pragma once

#include <vector>

#include "check/model_examination.hpp"
#include "model/parts.hpp"

namespace gxrod {

// Whether one of the part's rods can touch something.
bool can_contact_hold(const ModelPart& part, const Model& model);

// Finds contact problems at the start of the first stage that a deck does not show: overlaps, touches, parts
// that only contact holds in statics, contact left out at joints, elements too long for their bends, steps
// too long for their speeds.
std::vector<Finding> examine_contact(const Model& model, const AnalysisSettings& analysis);

}  // namespace gxrod
