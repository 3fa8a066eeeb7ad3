#pragma once

#include "deck/build_context.hpp"

namespace gxrod {

// Adds the sections to the model.
void build_sections(BuildContext& context);

// Adds the rods and their nodes to the model. `points` are those of the deck's texts that name a point of a
// rod.
void build_rods(const std::vector<RodPoint>& points, BuildContext& context);

}  // namespace gxrod
