#pragma once

#include <vector>

#include "check/model_examination.hpp"
#include "model/parts.hpp"

namespace gxrod {

// Whether one of its rods can touch something.
bool can_contact_hold(const ModelPart& part, const Model& model);

// What a reader of a deck cannot see of contact at the start of its first stage: what overlaps, what touches
// already, what contact alone holds in statics, what is left out at joints, elements too long for their
// bends, steps too long for their speeds.
std::vector<Finding> examine_contact(const Model& model, const AnalysisSettings& analysis);

}  // namespace gxrod
