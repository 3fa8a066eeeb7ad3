#pragma once

#include <cstddef>
#include <vector>

#include "linear/fronts/elimination_order.hpp"

namespace gxrod {

// The steps of an order in tasks that several threads can take at once: a step is in a later level than the
// steps of other tasks that it builds on. What a task changes of blocks that are not its own is added up
// separately and belongs to the task that continues with them. Tasks depend on the matrix alone, not on the
// threads.
struct EliminationTasks {
    struct Task {
        std::size_t first, last;  // steps
    };

    std::vector<Task> tasks;
    std::vector<std::size_t> level_starts;  // among the tasks, and the number of these; empty without steps

    // Puts the steps into the order of the tasks, and within them each behind those that it builds on.
    EliminationTasks(const BlockPartition& blocks, std::vector<EliminationOrder::Step>& steps);

    std::size_t level_count() const { return level_starts.empty() ? 0 : level_starts.size() - 1; }
};

}  // namespace gxrod
