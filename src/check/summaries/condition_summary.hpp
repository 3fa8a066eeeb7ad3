#pragma once

#include <vector>

#include "check/summaries/tendon_summary.hpp"
#include "model/model.hpp"

namespace gxrod {

// Lists connections, supports, initial velocities, loads, tendons, inputs and gravity of a model, in lines.
// `words` adds to each input what reads it.
std::vector<ItemList> list_conditions(const Model& model, const DeckWords& words = {});

}  // namespace gxrod
