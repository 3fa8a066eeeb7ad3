#pragma once

#include <string>
#include <vector>

#include "batch/cases/case_row.hpp"

namespace gxrod {

// Puts '#' in place of each number in a text, so that texts that differ only in numbers become equal.
std::string leave_out_numbers(const std::string& text);

// Cases that ended for the same reason, apart from numbers in it.
struct CaseGroup {
    CaseStatus status;
    std::string text;  // reason of the first one
    std::vector<long> numbers;
};

// Groups cases that are not done by their reasons, the largest group first.
std::vector<CaseGroup> group_failures(const std::vector<CaseRow>& rows);
// Groups warnings likewise.
std::vector<CaseGroup> group_warnings(const std::vector<CaseRow>& rows);

}  // namespace gxrod
