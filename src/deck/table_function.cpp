#include "deck/table_function.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace gxrod {

double interpolate(const std::vector<std::pair<double, double>>& table, double time) {
    assert(!table.empty());
    if (std::isnan(time)) return time;
    const auto later = std::upper_bound(
        table.begin(), table.end(), time, [](double t, const auto& row) { return t < row.first; });
    if (later == table.begin()) return table.front().second;
    if (later == table.end()) return table.back().second;
    const auto& [t0, value0] = *(later - 1);
    const auto& [t1, value1] = *later;
    return value0 + (value1 - value0) * ((time - t0) / (t1 - t0));
}

}  // namespace gxrod
