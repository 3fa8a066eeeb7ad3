#pragma once

#include <vector>

#include "check/summaries/item_list.hpp"
#include "model/model.hpp"

namespace gxrod {

// Connections, supports, initial velocities, loads and gravity of a model, in lines for a reader.
std::vector<ItemList> list_conditions(const Model& model);

}  // namespace gxrod
