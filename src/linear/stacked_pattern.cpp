#include "linear/stacked_pattern.hpp"

#include <algorithm>

namespace gxrod {

StackedPattern::StackedPattern(const SparsePattern& pattern, int copies)
    : original_(&pattern), copies_(copies), stacked_(make_stacked()) {}

// Blocks of columns are those of rows too, since the pattern is symmetric: where a run of rows begins or ends
// within a block of columns, that block is cut.
SparsePattern StackedPattern::make_stacked() {
    std::vector<std::int64_t> cuts{0};
    for (std::size_t i = 0; i < original_->block_count(); ++i) {
        const SparsePattern::Block block = original_->block(i);
        cuts.push_back(block.first_column + block.columns);
        for (const SparsePattern::RowRun& run : block.runs) {
            cuts.push_back(run.first);
            cuts.push_back(run.first + run.count);
        }
    }
    std::ranges::sort(cuts);
    cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) blocks_.push_back({cuts[i], cuts[i + 1] - cuts[i]});

    SparsePattern stacked;
    stacked.reserve(blocks_.size());
    std::vector<std::int64_t> rows;
    for (const Rows& own : blocks_) {
        rows.clear();
        for (const SparsePattern::RowRun& run : original_->block_of(own.first).runs) {
            for (std::int64_t row = copies_ * run.first; row < copies_ * (run.first + run.count); ++row)
                rows.push_back(row);
        }
        stacked.add_columns(copies_ * own.count, rows);
    }
    return stacked;
}

void StackedPattern::set(int equations,
                         int unknowns,
                         const std::vector<double>& from,
                         double factor,
                         std::vector<double>& to) const {
    to.resize(static_cast<std::size_t>(stacked_.nonzeros()));
    for (const Rows& own : blocks_) {
        const SparsePattern::Block source = original_->block_of(own.first);
        const SparsePattern::Block target = stacked_.block_of(copies_ * own.first);
        for (std::int64_t i = 0; i < own.count; ++i) {
            const double* value = &from[static_cast<std::size_t>(
                source.first_entry + (own.first - source.first_column + i) * source.stride)];
            const std::int64_t column = copies_ * own.first + unknowns * own.count + i;
            double* entry = &to[static_cast<std::size_t>(target.first_entry +
                                                         (column - target.first_column) * target.stride)];
            for (const SparsePattern::RowRun& run : source.runs) {
                auto block = std::ranges::lower_bound(blocks_, run.first, {}, &Rows::first);
                for (std::int64_t done = 0; done < run.count; done += block->count, ++block) {
                    for (std::int64_t k = 0; k < block->count; ++k)
                        entry[equations * block->count + k] = factor * *value++;
                    entry += copies_ * block->count;
                }
            }
        }
    }
}

void StackedPattern::set(int copy, const Eigen::VectorXd& from, Eigen::VectorXd& to) const {
    to.resize(copies_ * from.size());
    for (const Rows& own : blocks_)
        to.segment(copies_ * own.first + copy * own.count, own.count) = from.segment(own.first, own.count);
}

void StackedPattern::get(int copy, const Eigen::VectorXd& from, Eigen::VectorXd& to) const {
    to.resize(from.size() / copies_);
    for (const Rows& own : blocks_)
        to.segment(own.first, own.count) = from.segment(copies_ * own.first + copy * own.count, own.count);
}

}  // namespace gxrod
