#pragma once

#include <cstddef>
#include <vector>

#include "linear/fronts/elimination_order.hpp"

namespace gxrod {

// Divides the steps of an order into tasks that several threads can take at once: a step is in a later level
// than the steps of other tasks on which it depends. Changes of a task to foreign blocks are summed up
// separately, for the task that continues with them. Tasks depend on the matrix alone, not on the threads.
struct EliminationTasks {
    struct Task {
        std::size_t first, last;  // steps
    };

    std::vector<Task> tasks;
    std::vector<std::size_t> level_starts;  // index among the tasks, and their number; empty without steps

    // Sorts the steps by tasks, and within tasks each behind the steps on which it depends.
    EliminationTasks(const BlockPartition& blocks, std::vector<EliminationOrder::Step>& steps);

    std::size_t level_count() const { return level_starts.empty() ? 0 : level_starts.size() - 1; }
};

}  // namespace gxrod
