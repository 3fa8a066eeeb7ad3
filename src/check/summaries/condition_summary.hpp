#pragma once

#include <vector>

#include "check/summaries/item_list.hpp"
#include "model/model.hpp"

namespace gxrod {

// Lists connections, supports, initial velocities, loads and gravity of a model, in lines.
std::vector<ItemList> list_conditions(const Model& model);

}  // namespace gxrod
