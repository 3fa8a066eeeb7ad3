#pragma once

#include <vector>

#include "deck/text/deck_tree.hpp"
#include "deck/text/fault_list.hpp"
#include "deck/text/table_files.hpp"
#include "model/deck_record.hpp"

namespace gxrod {

// Puts the rows of each function's `file` and `columns` in place of these keys, as `table`; the deck's other
// keys stay. What is wrong with a file or its columns becomes a fault, and its keys stay too. The files are
// added to the records.
void fill_function_tables(DeckNode& deck,
                          const TableFiles& files,
                          std::vector<MeshRecord>& records,
                          FaultList& faults);

// Whether any function of the deck names a file.
bool has_function_files(const DeckNode& deck);

}  // namespace gxrod
