#pragma once

#include <optional>
#include <string>
#include <vector>

#include "batch/cases/case_table.hpp"

namespace gxrod {

// Writes a range in the form of --only: "3..7", or "3" for one case.
std::string write_range(const CaseRange& range);

// Joins ascending numbers into ranges: 1, 2, 3, 7 give 1..3 and 7.
std::vector<CaseRange> join_numbers(const std::vector<long>& numbers);

bool contain(const std::vector<CaseRange>& ranges, long number);

// Divides ascending cases into slices whose sizes differ by at most one. No slice has a case of `taken`
// between its ends, so there can be more slices than requested. Slices do not overlap.
std::vector<CaseRange> divide_cases(const std::vector<long>& cases,
                                    const std::vector<CaseRange>& taken,
                                    long slices);

}  // namespace gxrod
