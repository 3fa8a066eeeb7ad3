#include "linear/chains/chain_layout.hpp"

#include <algorithm>

namespace gxrod {
namespace {

class Builder {
  public:
    Builder(ChainLayout& layout,
            const SparsePattern& pattern,
            const BlockPartition& partition,
            const EliminationOrder& order,
            const EliminationTasks& tasks)
        : layout_(layout),
          pattern_(pattern),
          partition_(partition),
          order_(order),
          tasks_(tasks),
          steps_of_(partition.count(), none),
          tasks_of_(order.steps.size()),
          first_couplings_(order.steps.size()),
          is_changed_(order.steps.size()),
          is_copied_(partition.count(), false),
          are_couplings_copied_(order.steps.size()),
          arrivals_(tasks.tasks.size() + 1),
          vector_arrivals_(tasks.tasks.size() + 1) {}

    void build() {
        for (std::size_t s = 0; s < order_.steps.size(); ++s)
            steps_of_[order_.steps[s].block] = static_cast<int>(s);
        for (std::size_t t = 0; t < tasks_.tasks.size(); ++t) {
            for (std::size_t s = tasks_.tasks[t].first; s < tasks_.tasks[t].last; ++s)
                tasks_of_[s] = static_cast<int>(t);
        }
        find_changed();
        take_places();
        for (std::size_t s = 0; s < order_.steps.size(); ++s) add_couplings(s);
        for (task_ = 0; task_ < junctions(); ++task_) add_task();
        add_kept();
        add_arrivals(layout_.tasks.emplace_back());
        layout_.level_starts = tasks_.level_starts;
        layout_.level_starts.push_back(layout_.tasks.size());
    }

  private:
    static constexpr int none = -1;

    // Of two blocks, the step that eliminates the first of them, and the other's place among its neighbours.
    struct Place {
        std::size_t step, neighbour;
        bool is_row_first;
    };
    // A block that was added up apart.
    struct Arrival {
        std::int64_t from;
        int row, column;
    };
    using Marks = std::array<bool, 2>;
    using Pair = std::pair<int, int>;  // column and row

    bool is_kept(int block) const { return steps_of_[block] < 0; }
    // The task that gets what belongs to blocks that are kept.
    int junctions() const { return static_cast<int>(tasks_.tasks.size()); }
    int count_neighbours(std::size_t s) const {
        const auto [a, b] = order_.steps[s].neighbours;
        return (a >= 0 ? 1 : 0) + (b >= 0 ? 1 : 0);
    }
    std::int64_t take(int row, int column) {
        const std::int64_t place = layout_.size;
        layout_.size += static_cast<std::int64_t>(partition_.size(row)) * partition_.size(column);
        return place;
    }
    Place find(int row, int column) const {
        const int of_row = steps_of_[row];
        const int of_column = steps_of_[column];
        const bool is_row_first = of_column < 0 || (of_row >= 0 && of_row < of_column);
        const std::size_t step = is_row_first ? of_row : of_column;
        const int other = is_row_first ? column : row;
        return {step, order_.steps[step].neighbours[0] == other ? 0U : 1U, is_row_first};
    }
    bool is_in_matrix(int row, int column) const {
        const auto first = partition_.neighbours.begin();
        return std::binary_search(
            first + static_cast<std::ptrdiff_t>(partition_.neighbour_starts[column]),
            first + static_cast<std::ptrdiff_t>(partition_.neighbour_starts[column + 1]),
            row);
    }

    void find_changed() {
        for (const EliminationOrder::Step& step : order_.steps) {
            const auto [a, b] = step.neighbours;
            if (b < 0 || (is_kept(a) && is_kept(b))) continue;
            const Place place = find(a, b);
            is_changed_[place.step][place.neighbour] = true;
        }
    }

    void take_places() {
        std::size_t couplings = 0;
        for (std::size_t s = 0; s < order_.steps.size(); ++s) couplings += count_neighbours(s);
        layout_.steps.reserve(order_.steps.size());
        layout_.couplings.reserve(couplings);
        for (std::size_t s = 0; s < order_.steps.size(); ++s) {
            const int block = order_.steps[s].block;
            layout_.steps.push_back({.diagonal = take(block, block),
                                     .across = -1,
                                     .back = -1,
                                     .first = static_cast<std::int32_t>(partition_.starts[block]),
                                     .size = partition_.size(block),
                                     .couplings = count_neighbours(s),
                                     .copies = 0});
            first_couplings_[s] = layout_.couplings.size();
            for (int i = 0; i < count_neighbours(s); ++i) {
                const int other = order_.steps[s].neighbours[i];
                ChainCoupling coupling{};
                if (is_changed_[s][i]) coupling.column.first = take(other, block);
                layout_.couplings.push_back(coupling);
            }
        }
        for (std::size_t s = 0; s < order_.steps.size(); ++s) {
            for (int i = 0; i < count_neighbours(s); ++i) {
                const int other = order_.steps[s].neighbours[i];
                layout_.couplings[first_couplings_[s] + i].to = take(order_.steps[s].block, other);
            }
        }
    }

    BlockPlace given(int row, int column) const {
        const std::int64_t first = partition_.starts[column];
        return {.first = pattern_.slot(partition_.starts[row], first),
                .stride = static_cast<std::int32_t>(pattern_.block(static_cast<std::size_t>(column)).stride),
                .is_given = true};
    }

    void add_couplings(std::size_t s) {
        const int block = order_.steps[s].block;
        for (int i = 0; i < count_neighbours(s); ++i) {
            const int other = order_.steps[s].neighbours[i];
            ChainCoupling& coupling = layout_.couplings[first_couplings_[s] + i];
            coupling.first = static_cast<std::int32_t>(partition_.starts[other]);
            coupling.size = partition_.size(other);
            if (is_changed_[s][i]) {
                coupling.row = {coupling.to, partition_.size(block), false};
                coupling.column = {coupling.column.first, coupling.size, false};
            } else {
                coupling.row = given(block, other);
                coupling.column = given(other, block);
            }
        }
    }

    // Where a block of two that remain, or of one, is worked on in the end; it begins as it is in the matrix.
    std::int64_t place_of(int row, int column, std::vector<BlockCopy>& copies) {
        std::int64_t to = 0;
        bool is_new = false;
        if (is_kept(row) && is_kept(column)) {
            const auto [found, is_added] = layout_.kept_blocks.try_emplace({column, row}, layout_.size);
            to = found->second;
            is_new = is_added;
            if (is_new) take(row, column);
        } else if (row == column) {
            to = layout_.steps[steps_of_[row]].diagonal;
            is_new = !is_copied_[row];
            is_copied_[row] = true;
        } else {
            const Place place = find(row, column);
            const ChainCoupling& coupling = layout_.couplings[first_couplings_[place.step] + place.neighbour];
            to = place.is_row_first ? coupling.to : coupling.column.first;
            bool& is_copied =
                are_couplings_copied_[place.step][place.is_row_first ? place.neighbour : 2 + place.neighbour];
            is_new = !is_copied;
            is_copied = true;
        }
        if (is_new) add_copy(row, column, to, copies);
        return to;
    }
    void add_copy(int row, int column, std::int64_t to, std::vector<BlockCopy>& copies) const {
        BlockCopy copy{-1, to, 0, partition_.size(row), partition_.size(column)};
        if (row == column || is_in_matrix(row, column)) {
            const BlockPlace from = given(row, column);
            copy.from = from.first;
            copy.stride = from.stride;
        }
        copies.push_back(copy);
    }

    // The task that continues with a block of two that remain, or of one; of those that are kept, the first
    // one that adds to it has it for itself.
    int find_owner(int row, int column) {
        if (is_kept(row) && is_kept(column)) return owners_.try_emplace({column, row}, task_).first->second;
        const std::size_t step = row == column ? steps_of_[row] : find(row, column).step;
        return tasks_of_[step];
    }
    // Where the current task adds to it.
    std::int64_t find_target(int row, int column) {
        if (find_owner(row, column) == task_) return place_of(row, column, layout_.copies);
        const auto [found, is_new] = apart_.try_emplace({column, row}, layout_.size);
        if (is_new) {
            take(row, column);
            layout_.copies.push_back({-1, found->second, 0, partition_.size(row), partition_.size(column)});
            const bool both_kept = is_kept(row) && is_kept(column);
            arrivals_[both_kept ? junctions() : find_owner(row, column)].push_back(
                {found->second, row, column});
        }
        return found->second;
    }
    std::int32_t find_vector_target(int block) {
        if (!is_kept(block) && tasks_of_[steps_of_[block]] == task_) return -1;
        const auto [found, is_new] = vector_apart_.try_emplace(block, layout_.apart);
        if (is_new) {
            layout_.apart += partition_.size(block);
            vector_arrivals_[is_kept(block) ? junctions() : tasks_of_[steps_of_[block]]].push_back(
                {found->second, static_cast<std::int32_t>(partition_.starts[block]), partition_.size(block)});
        }
        return found->second;
    }

    void add_targets(std::size_t s) {
        const EliminationOrder::Step& order = order_.steps[s];
        const auto [a, b] = order.neighbours;
        const std::size_t before = layout_.copies.size();
        place_of(order.block, order.block, layout_.copies);
        for (int i = 0; i < count_neighbours(s); ++i) {
            ChainCoupling& coupling = layout_.couplings[first_couplings_[s] + i];
            coupling.diagonal = find_target(order.neighbours[i], order.neighbours[i]);
            coupling.apart = find_vector_target(order.neighbours[i]);
        }
        if (b >= 0) {
            layout_.steps[s].across = find_target(a, b);
            layout_.steps[s].back = find_target(b, a);
        }
        layout_.steps[s].copies = static_cast<std::int32_t>(layout_.copies.size() - before);
    }

    void add_task() {
        const auto [first, last] = tasks_.tasks[task_];
        ChainTask& task = layout_.tasks.emplace_back();
        apart_.clear();
        vector_apart_.clear();
        add_arrivals(task);
        task.steps = {static_cast<std::int64_t>(first), static_cast<std::int64_t>(last - first)};
        task.couplings.first = static_cast<std::int64_t>(first_couplings_[first]);
        task.copies.first = static_cast<std::int64_t>(layout_.copies.size());
        task.apart.first = layout_.apart;
        for (std::size_t s = first; s < last; ++s) {
            task.couplings.count += count_neighbours(s);
            add_targets(s);
        }
        task.copies.count = static_cast<std::int64_t>(layout_.copies.size()) - task.copies.first;
        task.apart.count = layout_.apart - task.apart.first;
    }

    // What earlier tasks have for the current one.
    void add_arrivals(ChainTask& task) {
        task.first_copies.first = static_cast<std::int64_t>(layout_.first_copies.size());
        task.merges.first = static_cast<std::int64_t>(layout_.merges.size());
        task.vector_merges = {static_cast<std::int64_t>(layout_.vector_merges.size()),
                              static_cast<std::int64_t>(vector_arrivals_[task_].size())};
        for (const auto& [from, row, column] : arrivals_[task_]) {
            const std::int64_t to = place_of(row, column, layout_.first_copies);
            layout_.merges.push_back({from, to, partition_.size(row) * partition_.size(column)});
        }
        task.first_copies.count =
            static_cast<std::int64_t>(layout_.first_copies.size()) - task.first_copies.first;
        task.merges.count = static_cast<std::int64_t>(layout_.merges.size()) - task.merges.first;
        layout_.vector_merges.insert(
            layout_.vector_merges.end(), vector_arrivals_[task_].begin(), vector_arrivals_[task_].end());
    }

    // What no step changed of blocks that are kept, with the last step.
    void add_kept() {
        const std::size_t before = layout_.copies.size();
        for (const int column : order_.kept) {
            place_of(column, column, layout_.copies);
            for (std::size_t i = partition_.neighbour_starts[column];
                 i < partition_.neighbour_starts[column + 1];
                 ++i) {
                const int row = partition_.neighbours[i];
                if (is_kept(row)) place_of(row, column, layout_.copies);
            }
        }
        layout_.steps.back().copies += static_cast<std::int32_t>(layout_.copies.size() - before);
    }

    ChainLayout& layout_;
    const SparsePattern& pattern_;
    const BlockPartition& partition_;
    const EliminationOrder& order_;
    const EliminationTasks& tasks_;
    std::vector<int> steps_of_;  // none of a kept block
    std::vector<int> tasks_of_;  // of steps
    std::vector<std::size_t> first_couplings_;
    std::vector<Marks> is_changed_;                          // a coupling, by a step before its own
    std::vector<bool> is_copied_;                            // a diagonal block
    std::vector<std::array<bool, 4>> are_couplings_copied_;  // rows, then columns
    std::vector<std::vector<Arrival>> arrivals_;             // for each task, from tasks before
    std::vector<std::vector<VectorMerge>> vector_arrivals_;
    std::map<Pair, int> owners_;  // of blocks that are kept
    // Of the current task:
    int task_ = 0;
    std::map<Pair, std::int64_t> apart_;
    std::map<int, std::int32_t> vector_apart_;
};

}  // namespace

ChainLayout::ChainLayout(const SparsePattern& pattern,
                         const BlockPartition& partition,
                         const EliminationOrder& order,
                         const EliminationTasks& elimination_tasks) {
    Builder(*this, pattern, partition, order, elimination_tasks).build();
    copies.shrink_to_fit();
}

std::vector<EntryRun> find_entry_runs(const SparsePattern& pattern) {
    std::vector<EntryRun> runs;
    runs.reserve(pattern.block_count());
    for (std::size_t index = 0; index < pattern.block_count(); ++index) {
        const SparsePattern::Block block = pattern.block(index);
        for (const SparsePattern::RowRun& run : block.runs) {
            runs.push_back({.first = block.first_entry + run.before,
                            .stride = static_cast<std::int32_t>(block.stride),
                            .row = static_cast<std::int32_t>(run.first),
                            .column = static_cast<std::int32_t>(block.first_column),
                            .rows = run.count,
                            .columns = static_cast<std::int32_t>(block.columns)});
        }
    }
    return runs;
}

}  // namespace gxrod
