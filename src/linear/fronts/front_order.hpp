#pragma once

#include <vector>

#include "linear/chains/block_partition.hpp"

namespace gxrod {

// The order of elimination of a system's blocks with little fill, and their grouping into fronts: blocks that
// couple the same later blocks, or nearly so. It comes from approximate minimum degree, or nested dissection
// if that fills in less; CHOLMOD of SuiteSparse does both. A front comes after the fronts from which it takes
// updates.
struct FrontOrder {
    std::vector<int> blocks;              // in the order of elimination
    std::vector<int> starts;              // start of each front in that order, and the number of blocks
    std::vector<std::size_t> row_starts;  // start of each front in `rows`, and the number of rows
    std::vector<int>
        rows;  // for each front its blocks and the later ones, ascending, by their place in that order

    // Throws std::runtime_error if memory does not suffice.
    explicit FrontOrder(const BlockPartition& partition);

    int count() const { return static_cast<int>(starts.size()) - 1; }
};

}  // namespace gxrod
