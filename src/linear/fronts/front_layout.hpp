#pragma once

#include <array>
#include <vector>

#include "linear/fronts/front_kernels.hpp"
#include "linear/fronts/front_order.hpp"
#include "linear/sparse_pattern.hpp"

namespace gxrod {

// The fronts of a FrontSolver on a symmetric pattern with its diagonal, each behind the fronts below it, and
// the places of their data.
struct FrontLayout {
    std::vector<Front> fronts;
    std::vector<FrontRun> runs;
    std::vector<FrontCopy> copies;
    std::vector<std::int32_t> children;
    std::vector<std::int64_t> unknowns;        // in the order of elimination
    std::int64_t factors = 0;                  // number of values
    std::array<std::int64_t, 2> stacks{0, 0};  // number of values of updates: even levels, odd levels
    std::int64_t most_rows = 0;                // most rows of a front after its pivots

    FrontLayout(const SparsePattern& pattern, const BlockPartition& partition, const FrontOrder& order);
};

}  // namespace gxrod
