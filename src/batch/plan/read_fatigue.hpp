#pragma once

#include <optional>

#include "batch/plan/plan.hpp"
#include "batch/plan/plan_tables.hpp"
#include "deck/text/fault_list.hpp"

namespace gxrod {

// Reads what is counted of a value's cycles, of a table that has `damage` or `range`; nothing with a fault.
std::optional<FatigueCount> read_fatigue(const CollectTable& table, FaultList& faults);

}  // namespace gxrod
