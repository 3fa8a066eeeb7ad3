#pragma once

#include "deck/checked_deck.hpp"
#include "deck/deck_tree.hpp"

namespace gxrod {

// Checks a deck against the schema: keys, types, ranges, expressions, what is missing. Every fault is added
// to the list; the result is complete only if none was.
CheckedTable check_deck(const DeckNode& deck, FaultList& faults);

}  // namespace gxrod
