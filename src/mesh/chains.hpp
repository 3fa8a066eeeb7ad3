#pragma once

#include <array>
#include <cstddef>
#include <vector>

// Orders line elements that come in any order and direction.
namespace gxrod {

struct ChainLink {
    std::size_t element;
    bool is_reversed = false;  // runs from the element's second end to its first
};

// Elements end to end, without a branch between.
struct Chain {
    std::vector<ChainLink> links;
    bool is_closed = false;  // ends where it starts, and no other element is there
};

// Chains from the ends of the elements: each runs between nodes where one element ends, or three or more
// meet, or around. The chains are in the order of their first elements, and a chain has the direction of its
// first element; but from a free end to a branch it runs from the free end. A closed chain starts with its
// first element. The two ends of an element differ.
std::vector<Chain> find_chains(const std::vector<std::array<std::size_t, 2>>& ends);

}  // namespace gxrod
