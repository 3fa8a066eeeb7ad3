#pragma once

#include <vector>

#include "check/summaries/item_list.hpp"
#include "model/model.hpp"

namespace gxrod {

// Lists the springs of a model, a line each, and the other ties that are elements, kind by kind.
std::vector<ItemList> list_element_summaries(const Model& model);

}  // namespace gxrod
