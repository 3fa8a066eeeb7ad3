#pragma once

#include <array>
#include <vector>

#include "linear/chains/block_partition.hpp"

namespace gxrod {

// In which order blocks that have two neighbours or fewer are eliminated, each from the system that the ones
// before left. Chains, trees and closed loops vanish; what is left are the junctions of a net, each with
// three neighbours or more. What lies between two blocks that are coupled already, such as nodes within an
// element, comes first; then ends of chains, all of them inwards at the same pace, so that halves of a rod do
// not wait for each other; then the others, along the chain. Only these fill in.
struct EliminationOrder {
    struct Step {
        int block;
        std::array<int, 2> neighbours{-1, -1};  // −1 if there are fewer
    };

    std::vector<Step> steps;
    std::vector<int> kept;  // blocks that are left, ascending
    int fills = 0;          // pairs of blocks that elimination couples

    // Blocks larger than `largest` are kept.
    EliminationOrder(const BlockPartition& blocks, int largest);
};

}  // namespace gxrod
