#pragma once

#include "deck/expressions/expression.hpp"
#include "deck/text/deck_tree.hpp"

namespace gxrod {

// The parameters, functions and inputs of a deck. What is wrong with a parameter goes to the fault list, as
// do cycles and names that are given twice; the keys of a [function.NAME] are checked with the other tables,
// so that here a wrong one is only marked as such. Inputs have no course yet (deck/drives/build_inputs.hpp).
Symbols read_symbols(const DeckNode& deck, FaultList& faults);

}  // namespace gxrod
