#pragma once

#include "deck/deck_tree.hpp"
#include "deck/fault_list.hpp"

namespace gxrod {

// Compares the deck of a run with one to go on with from where it stopped: a fault for each key that differs
// and may not. What may: title, units, [output], which histories there are and what they record, and of
// [analysis] end_time, time_step, steps, adaptive, newton and linear_solver.
void check_resumption(const DeckNode& before, const DeckNode& now, FaultList& faults);

}  // namespace gxrod
