#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "check/summaries/item_list.hpp"
#include "model/model.hpp"

namespace gxrod {

// The keys of a deck that read an input, by its name.
using InputUses = std::map<std::string, std::vector<std::string>>;

// Holds what the deck of a model says of its parts, which the model does not know.
struct DeckWords {
    InputUses uses = {};
    std::set<std::string> chambers = {};  // names of tendons that are chambers
};

// Lists the tendons of a model: path, ends, pull and friction at t = 0.
ItemList list_tendons(const Model& model, const DeckWords& words = {});
// Lists the inputs of a model, and what reads each.
ItemList list_inputs(const Model& model, const DeckWords& words = {});

}  // namespace gxrod
