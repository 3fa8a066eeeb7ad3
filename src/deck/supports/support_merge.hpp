#pragma once

#include <string_view>

#include "deck/places/build_context.hpp"

namespace gxrod {

// The supports of a deck at one node, together.
struct NodeSupport {
    Support support;
    std::vector<const CheckedTable*> tables;
    std::array<const CheckedTable*, 6>
        holders{};  // of each component: the first table that fixes or moves it
};

// The values of a table's `move`, by component; nullptr for one that it does not move.
std::array<const CheckedTimeFunction*, 6> moves_of(const CheckedTable& table);

// Adds a table at the node to what supports it already. Faults: invalid axes or not those of another
// table, a component that is fixed and moved, or moved twice.
void merge_support(const CheckedTable& table, NodeSupport& merged, const BuildContext& context);

}  // namespace gxrod
