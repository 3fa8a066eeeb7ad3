#pragma once

#include <span>

#include "deck/analyses/analysis_table.hpp"
#include "deck/places/build_context.hpp"

namespace gxrod {

// Builds the settings of a path, without Newton's method and without what needs nodes.
PathSettings build_path(const AnalysisTable& table, const BuildContext& context);

// Lets the last of these stages, whose table this is, follow a limit point of an earlier one, if it asks to.
void build_follow(const AnalysisTable& table, std::span<StagePlan> stages, const BuildContext& context);

// Where paths must have equilibria; once points have nodes and stages have supports.
void build_path_targets(BuildContext& context);

}  // namespace gxrod
