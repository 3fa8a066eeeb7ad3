#pragma once

#include <functional>
#include <vector>

#include "deck/text/deck_tree.hpp"
#include "deck/text/fault.hpp"

namespace gxrod {

// Finds more faults of a deck, as its reader stops at the first phase with faults: keys and types, files,
// names and geometry. Removes the faulty entries from the deck, with all that refers to them, and lets
// `build` read the rest, which throws DeckError, as long as it finds more. Returns all faults in deck order.
// Faults that could follow from a removal are left for the next run.
std::vector<DeckFault> find_further_faults(std::vector<DeckFault> first,
                                           DeckNode deck,
                                           const std::function<void(const DeckNode& deck)>& build);

}  // namespace gxrod
