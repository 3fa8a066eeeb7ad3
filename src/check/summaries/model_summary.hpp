#pragma once

#include <string>
#include <vector>

#include "check/summaries/item_list.hpp"
#include "model/model.hpp"
#include "model/settings/settings.hpp"
#include "model/settings/stage.hpp"

namespace gxrod {

// What a run of the model would be, in lines for a reader: parts, constants and conditions; masses, unknowns;
// analysis; output.
std::vector<ItemList> list_model(const Model& model);
std::string describe_total(const Model& model);
std::string describe_analysis(const AnalysisSettings& settings);
std::string describe_output(const std::vector<StagePlan>& stages, const OutputSettings& output);

// The name of an integrator as decks have it.
const char* name_of(Scheme scheme);

}  // namespace gxrod
