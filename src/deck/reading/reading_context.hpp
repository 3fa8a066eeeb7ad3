#pragma once

#include "deck/expressions/expression.hpp"
#include "deck/reading/deck_tree.hpp"
#include "deck/schema/schema.hpp"

namespace gxrod {

// What all readers need.
struct ReadingContext {
    const Symbols& symbols;
    FaultList& faults;
};

// 'a boolean', 'the text "abc"', 'an array of 2', as messages say what they found.
std::string describe_found(const DeckNode& node);

}  // namespace gxrod
