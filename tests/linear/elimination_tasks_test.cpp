#include "linear/chains/elimination_tasks.hpp"

#include "solvers/sparse_samples.hpp"
#include "tools/catch.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

constexpr int large = 1000;

struct Sample {
    BlockPartition blocks;
    EliminationOrder order;
    EliminationTasks tasks;

    explicit Sample(const SparsePattern& pattern)
        : blocks(pattern), order(blocks, large), tasks(blocks, order.steps) {}

    std::int64_t size(std::size_t task) const {
        std::int64_t sum = 0;
        for (std::size_t s = tasks.tasks[task].first; s < tasks.tasks[task].last; ++s)
            sum += blocks.size(order.steps[s].block);
        return sum;
    }
};

// Every step once, after what it builds on, which another task of its level does not have.
void check_order(const Sample& sample) {
    const auto& [blocks, order, tasks] = sample;
    std::vector<int> level_of(blocks.count(), -1);
    std::vector<int> task_of(blocks.count(), -1);
    std::size_t next = 0;
    for (int level = 0; level < static_cast<int>(tasks.level_count()); ++level) {
        for (std::size_t task = tasks.level_starts[level]; task < tasks.level_starts[level + 1]; ++task) {
            CHECK(tasks.tasks[task].first == next);
            for (; next < tasks.tasks[task].last; ++next) {
                const EliminationOrder::Step& step = order.steps[next];
                REQUIRE(task_of[step.block] == -1);
                task_of[step.block] = static_cast<int>(task);
                level_of[step.block] = level;
                for (const int other : step.neighbours) {
                    // Neighbours of a step are eliminated later, or never.
                    if (other >= 0) REQUIRE(task_of[other] == -1);
                }
            }
        }
    }
    CHECK(next == order.steps.size());
    for (const EliminationOrder::Step& step : order.steps) {
        for (const int other : step.neighbours) {
            if (other < 0 || task_of[other] < 0 || task_of[other] == task_of[step.block]) continue;
            CHECK(level_of[other] > level_of[step.block]);
        }
    }
}

}  // namespace

TEST_CASE("A short rod is one task", "[linear]") {
    const Sample rod(make_net_pattern(1, 100));
    check_order(rod);
    CHECK(rod.tasks.tasks.size() == 1);
}

TEST_CASE("A long rod is two halves and what is between them", "[linear]") {
    const Sample rod(make_net_pattern(1, 1001));
    check_order(rod);
    REQUIRE(rod.tasks.tasks.size() == 3);
    CHECK(rod.tasks.level_count() == 2);
    CHECK(rod.size(0) == 3000);
    CHECK(rod.size(1) == 3000);
    CHECK(rod.size(2) == 6);
}

TEST_CASE("Tasks of what is left of a net share small chains", "[linear]") {
    const Sample ladder(make_net_pattern(2, 700));
    check_order(ladder);
    CHECK(ladder.order.kept.empty());
    const Sample net(make_net_pattern(4, 4));
    check_order(net);
    CHECK(net.tasks.tasks.size() == 1);
}
