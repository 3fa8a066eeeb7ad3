#pragma once

#include <array>
#include <cstddef>
#include <vector>

// Puts line elements of any order and direction into chains.
namespace gxrod {

struct ChainLink {
    std::size_t element;
    bool is_reversed = false;  // runs from the element's second end to its first
};

// Elements end to end, without a branch between.
struct Chain {
    std::vector<ChainLink> links;
    bool is_closed = false;  // ends where it starts, without other elements there
};

// Finds chains from the ends of the elements: each runs between nodes where one element ends, or three or
// more meet, or around. The chains are in the order of their first elements, and a chain has the direction of
// its first element; but from a free end to a branch it runs from the free end. A closed chain starts with
// its first element. The two ends of an element differ.
std::vector<Chain> find_chains(const std::vector<std::array<std::size_t, 2>>& ends);

}  // namespace gxrod
