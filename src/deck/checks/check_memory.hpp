#pragma once

#include "deck/reading/checked_deck.hpp"
#include "deck/rods/read_rod_nets.hpp"
#include "deck/text/fault_list.hpp"

namespace gxrod {

// Bytes that a run needs for each node of a rod at the least: motions at two time levels, a row of the
// block-tridiagonal tangent and of its factors.
double least_bytes_of_node();

// A fault of the rod with the most nodes if a run needs more memory than there is, before any of it is taken.
void check_memory(const CheckedTable& deck, const RodNets& nets, double usable_bytes, FaultList& faults);

}  // namespace gxrod
