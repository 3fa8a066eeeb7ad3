#pragma once

#include "deck/text/deck_tree.hpp"
#include "deck/text/fault_list.hpp"
#include "model/model.hpp"

namespace gxrod {

// Compares the deck of a run with one to resume it with from where it stopped: a fault for each key that
// must not differ but does. What can differ: title, units, [output], which histories there are and what they
// record, and of [analysis] end_time, time_step, steps, adaptive, newton and linear_solver, and of a path its
// own keys.
void check_resumption(const DeckNode& before, const DeckNode& now, FaultList& faults);

// Whether nodes, elements and bodies are the same, in the same order: a state of one model fits the other.
bool have_same_mesh(const Model& before, const Model& now);

}  // namespace gxrod
