#pragma once

#include <filesystem>
#include <vector>

#include "batch/plan/plan.hpp"
#include "deck/text/fault_list.hpp"

namespace gxrod {

// Reads the entries of [vary], in the order of the plan. Faults go to the fault list.
std::vector<Variation> read_variations(const DeckNode& vary, Combination combination, FaultList& faults);

// Adds faults for keys that are equal or contain each other, as the value of one would be lost.
void check_conflicts(const std::vector<Variation>& variations, FaultList& faults);

// Fills in the values of a table's columns: the columns that `variations` name, or a variation for each
// column if there are none. `place` is the place of the key `table`. Faults of the columns go to the fault
// list. Throws FileError if the table cannot be read or its rows differ in length.
void read_table_columns(const std::filesystem::path& table,
                        const Place& place,
                        std::vector<Variation>& variations,
                        FaultList& faults);

}  // namespace gxrod
