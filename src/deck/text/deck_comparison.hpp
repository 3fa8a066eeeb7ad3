#pragma once

#include <string>
#include <vector>

#include "deck/text/deck_tree.hpp"
#include "deck/text/fault_list.hpp"

namespace gxrod {

struct ComparisonRules {
    // Keys that may differ: "output", "analysis.newton", "stage[].steps" of every stage.
    std::vector<std::string> free_paths;
    std::string before_has;  // words before a value in messages: "the run to be resumed has "
};

// Adds a fault, at its place in `now`, for each key whose value differs. Numbers are compared by value; the
// order of keys does not matter.
void compare_decks(const DeckNode& before,
                   const DeckNode& now,
                   const ComparisonRules& rules,
                   FaultList& faults,
                   const std::string& path = "");

}  // namespace gxrod
