#pragma once

#include <string>
#include <vector>

#include "batch/plan/plan_words.hpp"

namespace gxrod {

// A number as --set takes it: the shortest decimal that is the same double, whole numbers without a point.
std::string write_number(double number);

// `count` numbers from one end to the other, both as given: with equal differences, or with equal ratios
// (both ends positive or both negative), to fifteen digits. `count` is at least 2.
std::vector<double> space_out(double from, double to, long count, Spacing spacing);

}  // namespace gxrod
