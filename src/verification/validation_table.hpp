#pragma once

#include <string>
#include <vector>

#include "verification/study.hpp"

// The table of `gxrod verify --all`, printed study by study as they end.
namespace gxrod {

// Returns the names of the columns.
std::string validation_head();

// Describes a study's checks, a line each: all that failed, and the first few of the others.
std::string describe_checks(const Study& study, const StudyResult& result, double seconds);

struct ValidationTotals {
    std::size_t studies = 0;
    std::size_t checks = 0;
    std::size_t missed = 0;
    double seconds = 0.0;
};

std::string describe_totals(const ValidationTotals& totals);

}  // namespace gxrod
