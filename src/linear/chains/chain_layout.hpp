#pragma once

#include <map>
#include <utility>
#include <vector>

#include "linear/chains/chain_kernels.hpp"
#include "linear/chains/elimination_tasks.hpp"

namespace gxrod {

// Sums that earlier tasks kept apart from a block, and from unknowns of the right-hand side.
struct BlockMerge {
    std::int64_t from, to;
    std::int32_t size;
};
struct VectorMerge {
    std::int32_t from, to, size;
};

// Steps that one thread takes: their parts of the lists below, and the work before them.
struct ChainTask {
    struct Part {
        std::int64_t first = 0;
        std::int64_t count = 0;
    };
    Part steps, couplings, copies;
    Part first_copies, merges, vector_merges;
    Part apart;  // entries of vectors to which it adds
};

// The steps of a ChainSolver on a pattern, and the working place of each block of the matrix, in the order of
// the steps. Blocks that no step changes are read from the given values. The last task has no steps: it
// merges sums into junctions.
struct ChainLayout {
    std::vector<ChainTask> tasks;
    std::vector<std::size_t> level_starts;  // index among the tasks, and the number of tasks
    std::vector<ChainStep> steps;
    std::vector<ChainCoupling> couplings;
    std::vector<BlockCopy> copies;
    std::vector<BlockCopy> first_copies;
    std::vector<BlockMerge> merges;
    std::vector<VectorMerge> vector_merges;
    std::int32_t apart = 0;                                   // entries of vectors to which tasks add
    std::map<std::pair<int, int>, std::int64_t> kept_blocks;  // places of kept blocks, by column and row
    std::int64_t size = 0;                                    // size of all working blocks

    ChainLayout(const SparsePattern& pattern,
                const BlockPartition& partition,
                const EliminationOrder& order,
                const EliminationTasks& tasks);
};

// Finds all entries of a pattern in runs.
std::vector<EntryRun> find_entry_runs(const SparsePattern& pattern);

}  // namespace gxrod
