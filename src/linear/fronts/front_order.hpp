#pragma once

#include <vector>

#include "linear/chains/block_partition.hpp"

namespace gxrod {

// In which order the blocks of a system are eliminated so that little fills in, and which of them together,
// as a front: those that couple the same blocks behind them, or nearly so. By approximate minimum degree, or
// nested dissection where that fills in less; CHOLMOD of SuiteSparse does both. A front comes after
// those that it takes updates from.
struct FrontOrder {
    std::vector<int> blocks;              // in the order of elimination
    std::vector<int> starts;              // of each front in that order, and the number of blocks
    std::vector<std::size_t> row_starts;  // of each front among `rows`, and their number
    std::vector<int> rows;                // of each front its blocks and those behind, ascending, by their
                                          // place in that order

    // Throws std::runtime_error if memory does not suffice.
    explicit FrontOrder(const BlockPartition& partition);

    int count() const { return static_cast<int>(starts.size()) - 1; }
};

}  // namespace gxrod
