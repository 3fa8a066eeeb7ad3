#pragma once

#include <string>
#include <vector>

#include "deck/expressions/expression.hpp"
#include "deck/schema/schema.hpp"
#include "deck/text/deck_tree.hpp"

namespace gxrod {

// Data that all readers need.
struct ReadingContext {
    const Symbols& symbols;
    FaultList& faults;
    // Words of the key that fit the rest of its table; empty if all do.
    std::vector<std::string> likely_words = {};
};

// Describes a found value in messages: 'a boolean', 'the text "abc"', 'an array of 2'.
std::string describe_found(const DeckNode& node);

}  // namespace gxrod
