#pragma once

#include <string>
#include <vector>

#include "deck/expressions/expression.hpp"
#include "deck/schema/schema.hpp"
#include "deck/text/deck_tree.hpp"

namespace gxrod {

// What all readers need.
struct ReadingContext {
    const Symbols& symbols;
    FaultList& faults;
    // Of the words of the key that is read, those that suit the rest of its table; empty if all of them do.
    std::vector<std::string> likely_words = {};
};

// 'a boolean', 'the text "abc"', 'an array of 2', as messages say what they found.
std::string describe_found(const DeckNode& node);

}  // namespace gxrod
