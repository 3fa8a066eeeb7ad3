#pragma once

#include "deck/reading/checked_deck.hpp"
#include "deck/rods/read_rod_nets.hpp"
#include "deck/text/fault_list.hpp"

namespace gxrod {

// Returns the least number of bytes that a run needs per node of a rod: motions at two time levels, a row of
// the block-tridiagonal tangent and of its factors.
double least_bytes_of_node();

// Adds a fault at the rod with the most nodes if a run needs more memory than there is, before any of it is
// allocated.
void check_memory(const CheckedTable& deck, const RodNets& nets, double usable_bytes, FaultList& faults);

}  // namespace gxrod
