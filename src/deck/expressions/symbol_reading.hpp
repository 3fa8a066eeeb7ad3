#pragma once

#include "deck/expressions/expression.hpp"
#include "deck/text/deck_tree.hpp"

namespace gxrod {

// Reads the parameters, functions and inputs of a deck. Wrong parameters, cycles and names that are given
// twice go to the fault list. The keys of a [function.NAME] are checked with the other tables; here a wrong
// function is only marked as wrong. Inputs have no course yet (deck/drives/build_inputs.hpp).
Symbols read_symbols(const DeckNode& deck, FaultList& faults);

}  // namespace gxrod
