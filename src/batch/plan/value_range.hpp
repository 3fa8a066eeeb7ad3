#pragma once

#include <string>
#include <vector>

#include "batch/plan/plan_words.hpp"

namespace gxrod {

// Writes a number in the form of --set: the shortest decimal that is the same double, whole numbers without a
// point.
std::string write_number(double number);

// Returns `count` ≥ 2 numbers from one end to the other, the ends exact: with equal differences, or with
// equal ratios (both ends positive or both negative), to fifteen digits.
std::vector<double> space_out(double from, double to, long count, Spacing spacing);

}  // namespace gxrod
