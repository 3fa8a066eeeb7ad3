#pragma once

#include <string>
#include <vector>

#include "check/findings/finding.hpp"
#include "model/model.hpp"
#include "model/settings/settings.hpp"
#include "model/settings/stage.hpp"

namespace gxrod {

// The start of an analysis: with the deck's shape and velocities, with the equilibrium of an earlier stage,
// or with the motion of an earlier stage.
enum class AnalysisStart { deck, equilibrium, motion };

// Finds problems that single keys of a deck do not show; errors come first. A later stage may move without a
// cause of its own.
std::vector<Finding> examine_model(const Model& model,
                                   const AnalysisSettings& analysis,
                                   AnalysisStart start = AnalysisStart::deck);

// Examines each stage; `model` has the actions of the first one. A finding that several stages share is
// reported once.
std::vector<Finding> examine_stages(const Model& model, const std::vector<StagePlan>& stages);

bool has_error(const std::vector<Finding>& findings);

// Describes a finding as a line, "warning: …".
std::string describe(const Finding& finding);

}  // namespace gxrod
