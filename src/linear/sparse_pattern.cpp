#include "linear/sparse_pattern.hpp"

#include <algorithm>
#include <cassert>

namespace gxrod {

namespace {

bool is_same(const SparsePattern::RowRun& a, const SparsePattern::RowRun& b) {
    return a.first == b.first && a.count == b.count;
}

}  // namespace

SparsePattern::Block SparsePattern::block(std::size_t index) const {
    const Start& first = starts_[index];
    const Start& last = starts_[index + 1];
    const std::span<const RowRun> runs(runs_.data() + first.run, runs_.data() + last.run);
    const std::int64_t stride = runs.empty() ? 0 : runs.back().before + runs.back().count;
    return {first.column, last.column - first.column, first.entry, stride, runs};
}

SparsePattern::Block SparsePattern::block_of(std::int64_t column) const {
    const auto after =
        std::upper_bound(starts_.begin(), starts_.end(), column, [](std::int64_t at, const Start& start) {
            return at < start.column;
        });
    return block(static_cast<std::size_t>(after - starts_.begin()) - 1);
}

std::int64_t SparsePattern::slot(std::int64_t row, std::int64_t column) const {
    const Block columns = block_of(column);
    const auto after = std::upper_bound(
        columns.runs.begin(), columns.runs.end(), row, [](std::int64_t at, const RowRun& run) {
            return at < run.first;
        });
    assert(after != columns.runs.begin());
    const RowRun& run = *(after - 1);
    assert(row < run.first + run.count);
    return columns.first_entry + (column - columns.first_column) * columns.stride + run.before +
           (row - run.first);
}

void SparsePattern::add_columns(std::int64_t columns, std::span<const std::int64_t> rows) {
    if (columns == 0) return;
    const std::size_t first_run = runs_.size();
    std::int32_t before = 0;
    for (const std::int64_t row : rows) {
        const bool follows = before > 0 && row == runs_.back().first + runs_.back().count;
        if (!follows) runs_.push_back({row, 0, before});
        ++runs_.back().count;
        ++before;
    }
    Start end = starts_.back();
    end.column += columns;
    end.entry += columns * static_cast<std::int64_t>(rows.size());
    const auto added = runs_.begin() + static_cast<std::ptrdiff_t>(first_run);
    if (block_count() > 0) {
        const std::span<const RowRun> last = block(block_count() - 1).runs;
        if (std::equal(last.begin(), last.end(), added, runs_.end(), is_same)) {
            runs_.erase(added, runs_.end());
            starts_.back() = end;
            return;
        }
    }
    end.run = runs_.size();
    starts_.push_back(end);
}

void SparsePattern::reserve(std::size_t blocks) {
    starts_.reserve(blocks + 1);
    runs_.reserve(blocks);
}

CompressedColumns::CompressedColumns(const SparsePattern& pattern) {
    column_starts.reserve(static_cast<std::size_t>(pattern.size()) + 1);
    for (std::size_t index = 0; index < pattern.block_count(); ++index) {
        const SparsePattern::Block block = pattern.block(index);
        for (std::int64_t i = 0; i < block.columns; ++i)
            column_starts.push_back(column_starts.back() + block.stride);
    }
    rows.reserve(static_cast<std::size_t>(pattern.nonzeros()));
    pattern.visit_entries([this](std::int64_t row, std::int64_t, std::int64_t) { rows.push_back(row); });
}

}  // namespace gxrod
