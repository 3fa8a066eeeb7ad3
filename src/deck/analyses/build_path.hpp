#pragma once

#include <span>

#include "deck/places/build_context.hpp"

namespace gxrod {

// What the keys of a path ask for, without Newton's method and what waits for nodes.
PathSettings build_path(const CheckedTable& table, const BuildContext& context);

// Of the last of these stages, whose table this is, if it follows a limit point of an earlier one.
void build_follow(const CheckedTable& table, std::span<StagePlan> stages, const BuildContext& context);

// Where paths must have equilibria; once points have nodes and stages have supports.
void build_path_targets(BuildContext& context);

}  // namespace gxrod
