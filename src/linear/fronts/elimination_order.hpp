#pragma once

#include <array>
#include <vector>

#include "linear/chains/block_partition.hpp"

namespace gxrod {

// The order in which blocks with two neighbours or fewer are eliminated, each from the system that the steps
// before left. Chains, trees and closed loops vanish; the junctions of a net remain, each with three
// neighbours or more. Blocks between two coupled blocks, such as nodes within an element, come first; then
// ends of chains, all of them inwards at the same pace, so that halves of a rod do not wait for each other;
// then the others, along the chain. Only these fill in.
struct EliminationOrder {
    struct Step {
        int block;
        std::array<int, 2> neighbours{-1, -1};  // −1 if there are fewer
    };

    std::vector<Step> steps;
    std::vector<int> kept;  // remaining blocks, ascending
    int fills = 0;          // pairs of blocks that elimination couples

    // Blocks larger than `largest` remain.
    EliminationOrder(const BlockPartition& blocks, int largest);
};

}  // namespace gxrod
