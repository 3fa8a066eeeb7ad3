#pragma once

#include <map>
#include <utility>
#include <vector>

#include "linear/chains/chain_kernels.hpp"
#include "linear/chains/elimination_tasks.hpp"

namespace gxrod {

// What tasks before added up apart from a block, and from unknowns of the right-hand side.
struct BlockMerge {
    std::int64_t from, to;
    std::int32_t size;
};
struct VectorMerge {
    std::int32_t from, to, size;
};

// Steps that one thread takes: their parts of the lists below, and what is done before them.
struct ChainTask {
    struct Part {
        std::int64_t first = 0;
        std::int64_t count = 0;
    };
    Part steps, couplings, copies;
    Part first_copies, merges, vector_merges;
    Part apart;  // entries of vectors that it adds to
};

// The steps of a ChainSolver on a pattern, and where each block of the matrix is worked on: those of a step
// together, in the order of the steps. Blocks that no step changes are read where they are given. The last
// task has no steps: with it, junctions get what is theirs.
struct ChainLayout {
    std::vector<ChainTask> tasks;
    std::vector<std::size_t> level_starts;  // among the tasks, and their number
    std::vector<ChainStep> steps;
    std::vector<ChainCoupling> couplings;
    std::vector<BlockCopy> copies;
    std::vector<BlockCopy> first_copies;
    std::vector<BlockMerge> merges;
    std::vector<VectorMerge> vector_merges;
    std::int32_t apart = 0;                                   // entries of vectors that tasks add to
    std::map<std::pair<int, int>, std::int64_t> kept_blocks;  // of those kept, by column and row
    std::int64_t size = 0;                                    // of all blocks that are worked on

    ChainLayout(const SparsePattern& pattern,
                const BlockPartition& partition,
                const EliminationOrder& order,
                const EliminationTasks& tasks);
};

// All entries of a pattern.
std::vector<EntryRun> find_entry_runs(const SparsePattern& pattern);

}  // namespace gxrod
