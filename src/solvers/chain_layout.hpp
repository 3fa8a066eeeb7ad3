#pragma once

#include <map>
#include <utility>
#include <vector>

#include "solvers/chain_kernels.hpp"
#include "solvers/elimination_order.hpp"

namespace gxrod {

// The steps of a ChainSolver on a pattern, and where each block of the matrix is worked on: those of a step
// together, in the order of the steps. Blocks that no step changes are read where they are given.
struct ChainLayout {
    std::vector<ChainStep> steps;
    std::vector<ChainCoupling> couplings;
    std::vector<BlockCopy> copies;
    std::map<std::pair<int, int>, std::int64_t> kept_blocks;  // of those kept, by column and row
    std::int64_t size = 0;                                    // of all blocks that are worked on

    ChainLayout(const SparsePattern& pattern, const BlockPartition& partition, const EliminationOrder& order);
};

// All entries of a pattern.
std::vector<EntryRun> find_entry_runs(const SparsePattern& pattern);

}  // namespace gxrod
