#pragma once

#include "deck/analyses/analysis_table.hpp"
#include "deck/places/build_context.hpp"

namespace gxrod {

// The frequencies that a response asks for; its forces wait for nodes.
ResponseSettings build_response(const AnalysisTable& table, const BuildContext& context);

// The forces of all responses; once points have nodes.
void build_excitation(BuildContext& context);

// Answers are recorded where the deck has histories, at nodes.
void name_response_points(const std::vector<HistoryRequest>& histories, BuildContext& context);

}  // namespace gxrod
