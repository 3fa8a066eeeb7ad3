#pragma once

#include <cstdint>
#include <vector>

#include "linear/sparse_pattern.hpp"

namespace gxrod {

// The unknowns of a symmetric pattern in blocks: consecutive unknowns whose columns have the same rows, such
// as the unknowns of a node, or of the nodes within an element. A block couples wholly to its neighbours.
struct BlockPartition {
    std::vector<std::int64_t> starts;  // the first unknown of each block, and the number of unknowns
    std::vector<std::size_t> neighbour_starts;
    std::vector<int> neighbours;  // neighbours of each block, ascending, without itself

    explicit BlockPartition(const SparsePattern& pattern);

    int count() const { return static_cast<int>(starts.size()) - 1; }
    int size(int block) const { return static_cast<int>(starts[block + 1] - starts[block]); }
};

}  // namespace gxrod
