#pragma once

#include <vector>

#include "deck/places/build_context.hpp"
#include "model/settings/history_request.hpp"

// Histories of both ends of lines, as output.line_ends asks for them.
namespace gxrod {

// Adds histories of the start and the end of each rod that the field of the table names: ROD_start and
// ROD_end, with tension, shear, moment and axis, and ROD_ground, where it touches the ground. Reports a fault
// if a history of the deck has such a name.
void add_line_ends(const TableHead& table,
                   const TableNames& field,
                   const BuildContext& context,
                   std::vector<HistoryRequest>& histories);

}  // namespace gxrod
