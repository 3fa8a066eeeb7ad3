#pragma once

#include <string_view>

#include "deck/loads/acting.hpp"

namespace gxrod {

// Prescribed motion, by component.
struct MoveTable : TableHead {
    std::array<std::optional<CheckedTimeFunction>, 6> components;
};

struct SupportTable : ActingTable {
    PointName at;
    std::optional<WordList> fix;
    std::optional<MoveTable> move;
    std::optional<Mat3> axes;
};

// The supports of a deck at one node, together.
struct NodeSupport {
    Support support;
    std::vector<const SupportTable*> tables;
    std::array<const SupportTable*, 6>
        holders{};  // of each component: the first table that fixes or moves it
};

// Adds a table at the node to what supports it already. Faults: invalid axes or not those of another
// table, a component that is fixed and moved, or moved twice.
void merge_support(const SupportTable& table, NodeSupport& merged, const BuildContext& context);

}  // namespace gxrod
