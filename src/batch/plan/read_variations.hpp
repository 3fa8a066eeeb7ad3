#pragma once

#include <filesystem>
#include <vector>

#include "batch/plan/plan.hpp"
#include "deck/text/fault_list.hpp"

namespace gxrod {

// The entries of [vary], in the order of the plan. What is wrong goes to the fault list.
std::vector<Variation> read_variations(const DeckNode& vary, Combination combination, FaultList& faults);

// Faults for keys that are equal, or one a part of the other: the value of one would be lost.
void check_conflicts(const std::vector<Variation>& variations, FaultList& faults);

// Fills in the values of a table's columns: those that `variations` name, or a variation for each column if
// there are none. `place` is that of the key `table`. What is wrong with the columns goes to the fault list.
// Throws FileError if the table cannot be read or its rows differ in length.
void read_table_columns(const std::filesystem::path& table,
                        const Place& place,
                        std::vector<Variation>& variations,
                        FaultList& faults);

}  // namespace gxrod
