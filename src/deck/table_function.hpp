#pragma once

#include <utility>
#include <vector>

namespace gxrod {

// The value at `time` of a table of (t, value), t increasing: linear between rows, the first and the last
// value held outside. The table must not be empty.
double interpolate(const std::vector<std::pair<double, double>>& table, double time);

}  // namespace gxrod
