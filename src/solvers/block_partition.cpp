#include "solvers/block_partition.hpp"

#include <algorithm>
#include <span>

namespace gxrod {
namespace {

std::span<const std::int64_t> rows_of(const SparsePattern& pattern, std::int64_t column) {
    return {pattern.rows.data() + pattern.column_starts[column],
            pattern.rows.data() + pattern.column_starts[column + 1]};
}

}  // namespace

BlockPartition::BlockPartition(const SparsePattern& pattern) {
    std::vector<int> block_of(static_cast<std::size_t>(pattern.size()));
    for (std::int64_t column = 0; column < pattern.size(); ++column) {
        const bool is_new =
            column == 0 || !std::ranges::equal(rows_of(pattern, column), rows_of(pattern, column - 1));
        if (is_new) starts.push_back(column);
        block_of[column] = static_cast<int>(starts.size()) - 1;
    }
    starts.push_back(pattern.size());
    neighbour_starts.push_back(0);
    for (int block = 0; block < count(); ++block) {
        int last = -1;
        for (const std::int64_t row : rows_of(pattern, starts[block])) {
            if (block_of[row] == last) continue;
            last = block_of[row];
            if (last != block) neighbours.push_back(last);
        }
        neighbour_starts.push_back(neighbours.size());
    }
}

}  // namespace gxrod
