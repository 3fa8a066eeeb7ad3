#pragma once

#include "deck/text/deck_tree.hpp"
#include "deck/text/fault_list.hpp"
#include "model/model.hpp"

namespace gxrod {

// Compares the deck of a run with the deck that resumes it, and adds a fault for each key that differs but
// must not: keys whose declaration says that they may change can differ, and the quantities of histories.
void check_resumption(const DeckNode& before, const DeckNode& now, FaultList& faults);

// Returns whether nodes, elements and bodies are the same, in the same order, so that a state of one model
// fits the other.
bool have_same_mesh(const Model& before, const Model& now);

}  // namespace gxrod
