#pragma once

#include <string>
#include <vector>

#include "check/findings/finding.hpp"
#include "model/model.hpp"
#include "model/settings/settings.hpp"
#include "model/settings/stage.hpp"

namespace gxrod {

// Where an analysis begins: from the deck's shape and velocities, from an equilibrium of a stage before, or
// with the motion of a stage before.
enum class AnalysisStart { deck, equilibrium, motion };

// What a reader of a deck cannot see in single keys: errors first. A later stage can move without a cause of
// its own.
std::vector<Finding> examine_model(const Model& model,
                                   const AnalysisSettings& analysis,
                                   AnalysisStart start = AnalysisStart::deck);

// The same of each stage; `model` has what acts in the first one. What several stages share is said once.
std::vector<Finding> examine_stages(const Model& model, const std::vector<StagePlan>& stages);

bool has_error(const std::vector<Finding>& findings);

// "warning: …", a line.
std::string describe(const Finding& finding);

}  // namespace gxrod
