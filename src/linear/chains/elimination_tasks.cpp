#include "linear/chains/elimination_tasks.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>

namespace gxrod {
namespace {

// Unknowns of a task, at least: as much work as threads take notice of.
constexpr std::int64_t task_size = 1000;
constexpr int none = -1;

using Steps = std::vector<EliminationOrder::Step>;

// Each step's parent is the one that continues with what it leaves, the first that eliminates a neighbour of
// it.
struct Forest {
    std::vector<int> parents, first_children, siblings;
    int first_root = none;

    Forest(const BlockPartition& blocks, const Steps& steps)
        : parents(steps.size(), none), first_children(steps.size(), none), siblings(steps.size(), none) {
        std::vector<int> steps_of(blocks.count(), none);
        for (std::size_t s = 0; s < steps.size(); ++s) steps_of[steps[s].block] = static_cast<int>(s);
        // From the last to the first, so that children come out in their order.
        for (int s = static_cast<int>(steps.size()) - 1; s >= 0; --s) {
            for (const int other : steps[s].neighbours) {
                const int next = other < 0 ? none : steps_of[other];
                if (next != none && (parents[s] == none || next < parents[s])) parents[s] = next;
            }
            int& first = parents[s] == none ? first_root : first_children[parents[s]];
            siblings[s] = first;
            first = s;
        }
    }

    // Each step after its children.
    std::vector<int> list_children_first() const {
        std::vector<int> list;
        list.reserve(parents.size());
        for (int s = descend(first_root); s != none;
             s = siblings[s] != none ? descend(siblings[s]) : parents[s])
            list.push_back(s);
        return list;
    }

  private:
    int descend(int s) const {
        while (s != none && first_children[s] != none) s = first_children[s];
        return s;
    }
};

// Which steps go together. The steps below one, and it, are next to each other in the list.
class Grouping {
  public:
    Grouping(const BlockPartition& blocks, const Steps& steps)
        : forest_(blocks, steps), list_(forest_.list_children_first()), tasks_(steps.size(), none) {
        std::vector<std::int64_t> sizes(steps.size(), 0);
        std::vector<std::size_t> counts(steps.size(), 1);
        for (std::size_t i = 0; i < list_.size(); ++i) {
            const int s = list_[i];
            sizes[s] += blocks.size(steps[s].block);
            if (sizes[s] >= task_size) {
                give_task(i, counts);
            } else if (forest_.parents[s] == none) {
                add_small_tree(i + 1 - counts[s], i, sizes[s]);
            }
            if (forest_.parents[s] == none) continue;
            sizes[forest_.parents[s]] += sizes[s];
            counts[forest_.parents[s]] += counts[s];
        }
    }

    const std::vector<int>& list() const { return list_; }
    int task_of(int step) const { return tasks_[step]; }
    const std::vector<int>& levels() const { return levels_; }  // of each task

  private:
    int add_task(int level) {
        levels_.push_back(level);
        return static_cast<int>(levels_.size()) - 1;
    }
    void fill(std::size_t first, std::size_t last, int task) {
        for (std::size_t i = first; i <= last; ++i) tasks_[list_[i]] = task;
    }

    // Where one large branch arrives it continues, where several do a new task begins; small ones join.
    void give_task(std::size_t place, const std::vector<std::size_t>& counts) {
        const int s = list_[place];
        int large = 0;
        int level = 0;
        int task = none;
        for (int child = forest_.first_children[s]; child != none; child = forest_.siblings[child]) {
            if (tasks_[child] == none) continue;
            ++large;
            task = tasks_[child];
            level = std::max(level, levels_[task] + 1);
        }
        if (large != 1) task = add_task(level);
        tasks_[s] = task;
        std::size_t end = place + 1 - counts[s];
        for (int child = forest_.first_children[s]; child != none; child = forest_.siblings[child]) {
            if (tasks_[child] == none) fill(end, end + counts[child] - 1, task);
            end += counts[child];
        }
    }

    // Whole trees that are small share tasks.
    void add_small_tree(std::size_t first, std::size_t last, std::int64_t size) {
        if (small_trees_ == none) small_trees_ = add_task(0);
        fill(first, last, small_trees_);
        small_trees_size_ += size;
        if (small_trees_size_ < task_size) return;
        small_trees_ = none;
        small_trees_size_ = 0;
    }

    Forest forest_;
    std::vector<int> list_;
    std::vector<int> tasks_;  // of each step
    std::vector<int> levels_;
    int small_trees_ = none;  // the task that takes more of them
    std::int64_t small_trees_size_ = 0;
};

}  // namespace

EliminationTasks::EliminationTasks(const BlockPartition& blocks, Steps& steps) {
    if (steps.empty()) return;
    const Grouping grouping(blocks, steps);
    const std::vector<int>& levels = grouping.levels();
    std::vector<int> order(levels.size());  // of the tasks
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return levels[a] < levels[b]; });
    std::vector<std::size_t> places(levels.size());  // where each task's next step goes
    std::vector<std::size_t> counts(levels.size(), 0);
    for (std::size_t s = 0; s < steps.size(); ++s) ++counts[grouping.task_of(static_cast<int>(s))];
    std::size_t first = 0;
    for (const int task : order) {
        if (levels[task] == static_cast<int>(level_starts.size())) level_starts.push_back(tasks.size());
        places[task] = first;
        first += counts[task];
        tasks.push_back({places[task], first});
    }
    level_starts.push_back(tasks.size());
    Steps arranged(steps.size());
    for (const int s : grouping.list()) arranged[places[grouping.task_of(s)]++] = steps[s];
    steps = std::move(arranged);
}

}  // namespace gxrod
