#pragma once

#include <optional>
#include <string>
#include <vector>

#include "batch/cases/case_table.hpp"

namespace gxrod {

// As --only takes it: "3..7", or "3" for one case.
std::string write_range(const CaseRange& range);

// Numbers in ascending order as ranges: 1, 2, 3, 7 are 1..3 and 7.
std::vector<CaseRange> join_numbers(const std::vector<long>& numbers);

bool contain(const std::vector<CaseRange>& ranges, long number);

// Cases, in ascending order, in slices of equal numbers of them, give or take one. No slice has a case of
// `taken` between its ends, so there can be more slices than asked for. Slices do not overlap.
std::vector<CaseRange> divide_cases(const std::vector<long>& cases,
                                    const std::vector<CaseRange>& taken,
                                    long slices);

}  // namespace gxrod
