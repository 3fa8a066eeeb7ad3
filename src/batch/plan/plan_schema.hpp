#pragma once

#include <string>

#include "deck/schema/schema.hpp"

// The keys of a plan, declared as those of a deck are.
namespace gxrod {

// The top level of a plan.
const TableSpec& plan_schema();

// An entry of [vary] that is not a list of values, and what it can hold.
const TableSpec& variation_table();

// The text of docs/plan.md, without its last line end.
std::string plan_reference();

// Cases beyond which a plan is refused.
inline constexpr long largest_case_count = 1'000'000;

}  // namespace gxrod
