#pragma once

#include <string>

#include "deck/schema/schema.hpp"

// The keys of a plan, declared like the keys of a deck.
namespace gxrod {

// Returns the top level of a plan.
const TableSpec& plan_schema();

// Returns the table of an entry of [vary] that is not a list of values.
const TableSpec& variation_table();

// Returns the text of docs/plan.md, without its last line end.
std::string plan_reference();

// Plans with more cases are refused.
inline constexpr long largest_case_count = 1'000'000;

}  // namespace gxrod
