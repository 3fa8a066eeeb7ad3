#pragma once

#include <array>
#include <vector>

#include "solvers/block_partition.hpp"

namespace gxrod {

// In which order blocks that have two neighbours or fewer are eliminated, each from the system that the ones
// before left. Chains, trees and closed loops vanish; what is left are the junctions of a net, each with
// three neighbours or more. Ends of chains come first, as nothing fills in there; then what lies between two
// blocks that are coupled already, such as nodes within an element; then the others, along the chain.
struct EliminationOrder {
    struct Step {
        int block;
        std::array<int, 2> neighbours{-1, -1};  // −1 if there are fewer
        bool fills = false;                     // couples two that were not coupled
    };

    std::vector<Step> steps;
    std::vector<int> kept;  // blocks that are left, ascending

    // Blocks larger than `largest` are kept.
    EliminationOrder(const BlockPartition& blocks, int largest);
};

}  // namespace gxrod
