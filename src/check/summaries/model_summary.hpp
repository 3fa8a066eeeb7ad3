#pragma once

#include <string>
#include <vector>

#include "check/summaries/tendon_summary.hpp"
#include "model/model.hpp"
#include "model/settings/settings.hpp"
#include "model/settings/signal_plan.hpp"
#include "model/settings/stage.hpp"

namespace gxrod {

// Lines about a run of the model: parts, constants and conditions; masses and unknowns; analysis; output.
std::vector<ItemList> list_model(const Model& model, const DeckWords& words = {});
std::string describe_total(const Model& model);
std::string describe_analysis(const AnalysisSettings& settings);
// A line for each signal.
std::string describe_signals(const std::vector<SignalPlan>& signals, const OutputSettings& output);
std::string describe_output(const std::vector<StagePlan>& stages, const OutputSettings& output);

}  // namespace gxrod
