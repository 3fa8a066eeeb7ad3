#pragma once

#include <algorithm>
#include <string_view>

#include "deck/loads/acting.hpp"
#include "deck/reading/copies.hpp"
#include "deck/supports/component_numbers.hpp"
#include "deck/table/place_kinds.hpp"

namespace gxrod {

// Prescribed motion, by component.
struct MoveTable : TableHead {
    std::array<std::optional<CheckedTimeFunction>, 6> components;
};

// Adds their keys, of a table whose struct has these components.
template <class T>
Table<T> with_components(Table<T> table) {
    for (std::size_t i = 0; i < component_names.size(); ++i) {
        const std::string axis(1, component_names[i].back());
        table
            .key(
                std::string(component_names[i]),
                [i](auto& move) -> auto& { return move.components[i]; },
                i < 3 ? "Displacement along " + axis + " since t = 0."
                      : "Component " + axis + " of the rotation vector.")
            .unit(i < 3 ? "length" : "angle");
    }
    return table;
}

struct SupportTable : ActingTable {
    std::optional<PointPatterns> at;
    std::optional<PlaceCondition> where;
    std::optional<WordList> fix;
    std::optional<MoveTable> move;
    std::optional<ComponentNumbers> stiffness, damping;
    std::optional<TableName> vessel;
    std::optional<Mat3> axes;
    Copies copies;

    bool yields() const { return stiffness || damping; }
    // Returns whether a component has stiffness or damping.
    bool yields(std::size_t component) const {
        return (stiffness && stiffness->values[component] > 0.0) ||
               (damping && damping->values[component] > 0.0);
    }
};

// The supports of a deck at one node, together.
struct NodeSupport {
    Support support;
    std::vector<const SupportTable*> tables;
    std::array<const SupportTable*, 6>
        holders{};  // of each component: the first table that fixes or moves it
    std::array<const SupportTable*, 6> yielding{};  // of each component: the first table by which it yields

    bool holds_any() const {
        return std::ranges::any_of(holders, [](const SupportTable* holder) { return holder != nullptr; });
    }
};

// Lists the components that a table with a vessel lets follow it: those of `fix`, the position if that is not
// given; without those that the plane of the deck holds.
std::vector<int> components_on_vessel(const SupportTable& table, const BuildContext& context);

// Adds a table at the node to what supports it already. Faults: invalid axes or not those of another
// table, a component that is fixed and moved, or moved twice, or yields too.
void merge_support(const SupportTable& table, NodeSupport& merged, const BuildContext& context);

// Adds faults of components that yield and are held at the same time.
void check_yielding(const NodeSupport& merged, const BuildContext& context);

}  // namespace gxrod
