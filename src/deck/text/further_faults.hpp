#pragma once

#include <functional>
#include <vector>

#include "deck/text/deck_tree.hpp"
#include "deck/text/fault.hpp"

namespace gxrod {

// What else is wrong with a deck than what its reader has found, where it stops at the first phase that finds
// something: keys and types, files, names and geometry. Takes what the faults are about out of the deck, with
// all that refers to it, and lets `build` read the rest, which throws DeckError, as long as that finds more.
// Returns all faults in deck order. A fault that could follow from what was taken out is left for the next
// time.
std::vector<DeckFault> find_further_faults(std::vector<DeckFault> first,
                                           DeckNode deck,
                                           const std::function<void(const DeckNode& deck)>& build);

}  // namespace gxrod
