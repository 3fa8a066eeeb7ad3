#include "linear/chains/block_partition.hpp"

#include <algorithm>

namespace gxrod {
BlockPartition::BlockPartition(const SparsePattern& pattern) {
    starts.reserve(pattern.block_count() + 1);
    for (std::size_t i = 0; i < pattern.block_count(); ++i) starts.push_back(pattern.block(i).first_column);
    starts.push_back(pattern.size());
    neighbour_starts.reserve(starts.size());
    neighbour_starts.push_back(0);
    for (int block = 0; block < count(); ++block) {
        for (const SparsePattern::RowRun& run : pattern.block(static_cast<std::size_t>(block)).runs) {
            auto after = std::upper_bound(starts.begin(), starts.end(), run.first);
            for (; *(after - 1) < run.first + run.count; ++after) {
                const int other = static_cast<int>(after - starts.begin()) - 1;
                if (other != block) neighbours.push_back(other);
            }
        }
        neighbour_starts.push_back(neighbours.size());
    }
}

}  // namespace gxrod
