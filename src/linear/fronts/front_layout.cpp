#include "linear/fronts/front_layout.hpp"

#include <algorithm>
#include <span>

namespace gxrod {
namespace {

class Builder {
  public:
    Builder(FrontLayout& layout,
            const SparsePattern& pattern,
            const BlockPartition& partition,
            const FrontOrder& order)
        : layout_(layout), pattern_(pattern), partition_(partition), order_(order) {}

    void build() {
        number_unknowns();
        find_parents();
        layout_.fronts.resize(order_.count());
        for (int front = 0; front < order_.count(); ++front) lay_out(front);
        add_children();
        place_updates();
        for (int front = 0; front < order_.count(); ++front) {
            add_runs(front);
            add_copies(front);
        }
    }

  private:
    std::span<const int> rows(int front) const {
        return std::span(order_.rows)
            .subspan(order_.row_starts[front], order_.row_starts[front + 1] - order_.row_starts[front]);
    }
    int count_pivots(int front) const { return order_.starts[front + 1] - order_.starts[front]; }
    int size(int place) const { return partition_.size(order_.blocks[place]); }

    void number_unknowns() {
        places_.resize(order_.blocks.size());
        for (std::size_t place = 0; place < order_.blocks.size(); ++place) {
            const int block = order_.blocks[place];
            places_[block] = static_cast<int>(place);
            first_unknowns_.push_back(static_cast<std::int32_t>(layout_.unknowns.size()));
            for (std::int64_t i = partition_.starts[block]; i < partition_.starts[block + 1]; ++i)
                layout_.unknowns.push_back(i);
        }
    }

    void find_parents() {
        std::vector<int> front_of(order_.blocks.size());
        for (int front = 0; front < order_.count(); ++front)
            std::fill(
                front_of.begin() + order_.starts[front], front_of.begin() + order_.starts[front + 1], front);
        for (int front = 0; front < order_.count(); ++front) {
            const std::span<const int> behind = rows(front).subspan(count_pivots(front));
            parents_.push_back(behind.empty() ? -1 : front_of[behind.front()]);
        }
    }

    void lay_out(int index) {
        Front& front = layout_.fronts[index];
        front.first = first_unknowns_[order_.starts[index]];
        for (const int place : rows(index)) front.rows += size(place);
        for (int place = order_.starts[index]; place < order_.starts[index + 1]; ++place)
            front.pivots += size(place);
        const std::int64_t behind = front.rows - front.pivots;
        front.lower = layout_.factors;
        layout_.factors += static_cast<std::int64_t>(front.rows) * front.pivots;
        front.upper = layout_.factors;
        layout_.factors += behind * front.pivots;
        layout_.most_rows = std::max(layout_.most_rows, behind);
    }

    void add_children() {
        std::vector<std::vector<std::int32_t>> children(order_.count());
        for (int front = 0; front < order_.count(); ++front) {
            if (parents_[front] >= 0) children[parents_[front]].push_back(front);
        }
        for (int front = 0; front < order_.count(); ++front) {
            layout_.fronts[front].children = static_cast<std::int64_t>(layout_.children.size());
            layout_.fronts[front].child_count = static_cast<std::int32_t>(children[front].size());
            layout_.children.insert(layout_.children.end(), children[front].begin(), children[front].end());
        }
    }

    // A front puts its update onto the stack of its level, and takes those of its children from the other.
    void place_updates() {
        for (int front = order_.count() - 1; front >= 0; --front) {
            if (parents_[front] >= 0) layout_.fronts[front].stack = 1 - layout_.fronts[parents_[front]].stack;
        }
        std::array<std::int64_t, 2> used{0, 0};
        for (Front& front : layout_.fronts) {
            const std::int64_t behind = front.rows - front.pivots;
            front.update = used[front.stack];
            used[front.stack] += behind * behind;
            layout_.stacks[front.stack] = std::max(layout_.stacks[front.stack], used[front.stack]);
            if (front.child_count > 0) {
                const Front& child = layout_.fronts[layout_.children[front.children]];
                used[child.stack] = child.update;
            }
        }
    }

    void add_runs(int index) {
        Front& front = layout_.fronts[index];
        front.runs = static_cast<std::int64_t>(layout_.runs.size());
        if (parents_[index] < 0) return;
        const int parent = parents_[index];
        const std::int32_t pivots = layout_.fronts[parent].pivots;
        const std::span<const int> above = rows(parent);
        std::size_t i = 0;
        std::int32_t row = 0;
        for (const int place : rows(index).subspan(count_pivots(index))) {
            for (; above[i] != place; ++i) row += size(above[i]);
            const std::int32_t unknown = first_unknowns_[place];
            FrontRun* last = front.run_count > 0 ? &layout_.runs.back() : nullptr;
            if (last && last->unknown + last->count == unknown && last->above + last->count == row &&
                row != pivots) {
                last->count += size(place);
            } else {
                layout_.runs.push_back({unknown, row, size(place)});
                ++front.run_count;
            }
        }
    }

    // Of each coupling of a pivot, where it is in the front.
    void add_copies(int index) {
        Front& front = layout_.fronts[index];
        front.copies = static_cast<std::int64_t>(layout_.copies.size());
        std::int32_t row = 0;
        for (const int place : rows(index)) {
            rows_of_[place] = row;
            row += size(place);
        }
        for (int pivot = order_.starts[index]; pivot < order_.starts[index + 1]; ++pivot) {
            const int block = order_.blocks[pivot];
            add_copy(front, pivot, pivot);
            for (std::size_t i = partition_.neighbour_starts[block];
                 i < partition_.neighbour_starts[block + 1];
                 ++i) {
                const int other = places_[partition_.neighbours[i]];
                if (other < pivot) continue;
                add_copy(front, other, pivot);
                add_copy(front, pivot, other);
            }
        }
        front.copy_count = static_cast<std::int32_t>(layout_.copies.size() - front.copies);
    }

    void add_copy(const Front& front, int row, int column) {
        const std::int64_t first_row = partition_.starts[order_.blocks[row]];
        const std::int64_t first = partition_.starts[order_.blocks[column]];
        const std::int64_t i = rows_of_[row];
        const std::int64_t j = rows_of_[column];
        const bool is_behind = j >= front.pivots;
        const std::int32_t stride = is_behind ? front.pivots : front.rows;
        const std::int64_t to =
            is_behind ? front.upper + (j - front.pivots) * stride : front.lower + j * stride;
        layout_.copies.push_back({.from = pattern_.slot(first_row, first),
                                  .to = to + i,
                                  .from_stride = static_cast<std::int32_t>(pattern_.block_of(first).stride),
                                  .to_stride = stride,
                                  .rows = size(row),
                                  .columns = size(column)});
    }

    FrontLayout& layout_;
    const SparsePattern& pattern_;
    const BlockPartition& partition_;
    const FrontOrder& order_;
    std::vector<int> places_;                   // of a block in the order of elimination
    std::vector<std::int32_t> first_unknowns_;  // by that place
    std::vector<int> parents_;                  // of each front that above it, or −1
    std::vector<std::int32_t> rows_of_ =
        std::vector<std::int32_t>(order_.blocks.size());  // of a block in the current front
};

}  // namespace

FrontLayout::FrontLayout(const SparsePattern& pattern,
                         const BlockPartition& partition,
                         const FrontOrder& order) {
    Builder(*this, pattern, partition, order).build();
    copies.shrink_to_fit();
}

}  // namespace gxrod
