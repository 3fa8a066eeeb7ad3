#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "deck/text/deck_tree.hpp"

namespace gxrod {

// Finds the keys of a valid deck whose expressions read an input or a signal, by its name:
// "load[0].moment[1]". All inputs and signals are there, also those that nothing reads.
std::map<std::string, std::vector<std::string>> find_input_uses(const DeckNode& deck);

// Lists the names of a kind of tables, such as "chamber" of [chamber.NAME].
std::set<std::string> list_table_names(const DeckNode& deck, std::string_view kind);

}  // namespace gxrod
