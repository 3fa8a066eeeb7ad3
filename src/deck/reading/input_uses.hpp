#pragma once

#include <map>
#include <string>
#include <vector>

#include "deck/text/deck_tree.hpp"

namespace gxrod {

// Finds the keys of a valid deck whose expressions read an input or a signal, by its name:
// "load[0].moment[1]". All inputs and signals are there, also those that nothing reads.
std::map<std::string, std::vector<std::string>> find_input_uses(const DeckNode& deck);

}  // namespace gxrod
