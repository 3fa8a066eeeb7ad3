#pragma once

#include <string>
#include <vector>

#include "batch/cases/case_row.hpp"

namespace gxrod {

// A text with '#' for each number, so that those that differ in numbers only are equal.
std::string leave_out_numbers(const std::string& text);

// Cases that ended the same way but for the numbers in their reasons.
struct CaseGroup {
    CaseStatus status;
    std::string text;  // of the first of them
    std::vector<long> numbers;
};

// Cases that are not done, by their reasons, the largest group first.
std::vector<CaseGroup> group_failures(const std::vector<CaseRow>& rows);
// The same of warnings.
std::vector<CaseGroup> group_warnings(const std::vector<CaseRow>& rows);

}  // namespace gxrod
