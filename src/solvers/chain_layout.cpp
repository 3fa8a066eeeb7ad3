#include "solvers/chain_layout.hpp"

#include <algorithm>

namespace gxrod {
namespace {

class Builder {
  public:
    Builder(ChainLayout& layout,
            const SparsePattern& pattern,
            const BlockPartition& partition,
            const EliminationOrder& order)
        : layout_(layout),
          pattern_(pattern),
          partition_(partition),
          order_(order),
          steps_of_(partition.count(), -1),
          first_couplings_(order.steps.size()),
          is_changed_(order.steps.size()),
          is_copied_(partition.count(), false),
          are_couplings_copied_(order.steps.size()) {}

    void build() {
        for (std::size_t s = 0; s < order_.steps.size(); ++s)
            steps_of_[order_.steps[s].block] = static_cast<int>(s);
        find_changed();
        take_places();
        for (std::size_t s = 0; s < order_.steps.size(); ++s) add_couplings(s);
        for (std::size_t s = 0; s < order_.steps.size(); ++s) add_copies(s);
        add_kept();
    }

  private:
    // Of two blocks, the step that eliminates the first of them, and the other's place among its neighbours.
    struct Place {
        std::size_t step, neighbour;
        bool is_row_first;
    };
    using Marks = std::array<bool, 2>;

    bool is_kept(int block) const { return steps_of_[block] < 0; }
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
        for (const int block : order_.kept) layout_.kept_blocks[{block, block}] = take(block, block);
    }

    std::int64_t diagonal(int block) const {
        return is_kept(block) ? layout_.kept_blocks.at({block, block})
                              : layout_.steps[steps_of_[block]].diagonal;
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
            coupling.diagonal = diagonal(other);
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

    void add_copy(int row, int column, std::int64_t to) {
        const BlockPlace from = given(row, column);
        layout_.copies.push_back(
            {from.first, to, from.stride, partition_.size(row), partition_.size(column)});
    }
    void copy_diagonal(int block) {
        if (is_copied_[block]) return;
        is_copied_[block] = true;
        add_copy(block, block, diagonal(block));
    }
    // Of two blocks that remain, coupled in the matrix or not.
    std::int64_t copy_coupling(int row, int column, bool is_zero) {
        std::int64_t to = 0;
        if (is_kept(row) && is_kept(column)) {
            const auto [found, is_new] = layout_.kept_blocks.try_emplace({column, row}, layout_.size);
            if (!is_new) return found->second;
            to = take(row, column);
        } else {
            const Place place = find(row, column);
            const ChainCoupling& coupling = layout_.couplings[first_couplings_[place.step] + place.neighbour];
            to = place.is_row_first ? coupling.to : coupling.column.first;
            bool& is_copied =
                are_couplings_copied_[place.step][place.is_row_first ? place.neighbour : 2 + place.neighbour];
            if (is_copied) return to;
            is_copied = true;
        }
        if (is_zero) {
            layout_.copies.push_back({-1, to, 0, partition_.size(row), partition_.size(column)});
        } else {
            add_copy(row, column, to);
        }
        return to;
    }

    void add_copies(std::size_t s) {
        const EliminationOrder::Step& order = order_.steps[s];
        const auto [a, b] = order.neighbours;
        const std::size_t before = layout_.copies.size();
        copy_diagonal(order.block);
        if (a >= 0) copy_diagonal(a);
        if (b >= 0) {
            copy_diagonal(b);
            layout_.steps[s].across = copy_coupling(a, b, order.fills);
            layout_.steps[s].back = copy_coupling(b, a, order.fills);
        }
        layout_.steps[s].copies = static_cast<std::int32_t>(layout_.copies.size() - before);
    }

    // What no step changed of blocks that are kept, with the last step.
    void add_kept() {
        const std::size_t before = layout_.copies.size();
        for (const int column : order_.kept) {
            copy_diagonal(column);
            for (std::size_t i = partition_.neighbour_starts[column];
                 i < partition_.neighbour_starts[column + 1];
                 ++i) {
                const int row = partition_.neighbours[i];
                if (is_kept(row)) copy_coupling(row, column, false);
            }
        }
        layout_.steps.back().copies += static_cast<std::int32_t>(layout_.copies.size() - before);
    }

    ChainLayout& layout_;
    const SparsePattern& pattern_;
    const BlockPartition& partition_;
    const EliminationOrder& order_;
    std::vector<int> steps_of_;  // −1 of a kept block
    std::vector<std::size_t> first_couplings_;
    std::vector<Marks> is_changed_;                          // a coupling, by a step before its own
    std::vector<bool> is_copied_;                            // a diagonal block
    std::vector<std::array<bool, 4>> are_couplings_copied_;  // rows, then columns
};

}  // namespace

ChainLayout::ChainLayout(const SparsePattern& pattern,
                         const BlockPartition& partition,
                         const EliminationOrder& order) {
    Builder(*this, pattern, partition, order).build();
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
