#pragma once

#include <string>
#include <vector>

#include "check/finding.hpp"
#include "model/model.hpp"
#include "model/settings.hpp"
#include "model/stage.hpp"

namespace gxrod {

// What a reader of a deck cannot see in single keys: errors first. A later stage does not begin at rest,
// and moves without a cause of its own.
std::vector<Finding> examine_model(const Model& model,
                                   const AnalysisSettings& analysis,
                                   bool begins_at_rest = true);

// The same of each stage; `model` has what acts in the first one. What several stages share is said once.
std::vector<Finding> examine_stages(const Model& model, const std::vector<StagePlan>& stages);

bool has_error(const std::vector<Finding>& findings);

// "warning: …", a line.
std::string describe(const Finding& finding);

}  // namespace gxrod
