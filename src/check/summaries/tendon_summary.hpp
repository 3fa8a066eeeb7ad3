#pragma once

#include <map>
#include <string>
#include <vector>

#include "check/summaries/item_list.hpp"
#include "model/model.hpp"

namespace gxrod {

// The keys of a deck that read an input, by its name.
using InputUses = std::map<std::string, std::vector<std::string>>;

// Lists the tendons of a model: path, ends, pull and friction at t = 0.
ItemList list_tendons(const Model& model);
// Lists the inputs of a model; `uses` adds what reads each.
ItemList list_inputs(const Model& model, const InputUses& uses);

}  // namespace gxrod
