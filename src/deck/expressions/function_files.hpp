#pragma once

#include <vector>

#include "deck/text/deck_tree.hpp"
#include "deck/text/fault_list.hpp"
#include "deck/text/table_files.hpp"
#include "model/deck_record.hpp"

namespace gxrod {

// Replaces the keys `file` and `columns` of each function by `table` with the rows of the file. If a file or
// its columns are wrong, adds a fault and leaves its keys. The files are added to the records.
void fill_function_tables(DeckNode& deck,
                          const TableFiles& files,
                          std::vector<MeshRecord>& records,
                          FaultList& faults);

// Returns whether any function of the deck names a file.
bool has_function_files(const DeckNode& deck);

}  // namespace gxrod
