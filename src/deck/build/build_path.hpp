#pragma once

#include "deck/build/build_context.hpp"

namespace gxrod {

// What the keys of a path ask for, without Newton's method and what waits for nodes.
PathSettings build_path(const CheckedTable& table, const BuildContext& context);

// Where paths must have equilibria; once points have nodes and stages have supports.
void build_path_targets(BuildContext& context);

}  // namespace gxrod
