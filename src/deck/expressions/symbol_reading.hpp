#pragma once

#include "deck/expressions/expression.hpp"
#include "deck/reading/deck_tree.hpp"

namespace gxrod {

// The parameters and functions of a deck. What is wrong with a parameter goes to the fault list, as do
// cycles; the keys of a [function.NAME] are checked with the other tables, so that here a wrong one is only
// marked as such.
Symbols read_symbols(const DeckNode& deck, FaultList& faults);

}  // namespace gxrod
