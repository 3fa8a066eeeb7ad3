#pragma once

#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "deck/reading/copies.hpp"
#include "deck/rods/curve_table.hpp"
#include "deck/sections/section_axes.hpp"
#include "deck/sections/section_tables.hpp"
#include "deck/table/kinds.hpp"

// The tables of [rod.NAME].
namespace gxrod {

struct SectionFileTable : TableHead {
    std::string file;
    std::optional<DampingTable> damping;
    std::optional<bool> trapeze;
};

struct RodMeshTable : TableHead {
    std::string file;
    GroupName group;
};

struct RestTable : CurveTable {
    std::optional<CheckedPlaceVector> curvature;
    SectionDirections axes;
    std::optional<NumberAlong> twist;
};

struct RodTable : CurveTable {
    std::optional<TableName> section;
    std::optional<std::variant<std::vector<CheckedStation>, SectionFileTable>> sections;
    std::optional<RodMeshTable> mesh;
    std::optional<long> elements;
    std::optional<CheckedProfile> spacing;
    long order = Rod{}.order;
    ElementKind element = Rod{}.kind;
    SectionDirections axes;
    NumberAlong twist = 0.0;
    std::optional<RestTable> rest;
    std::optional<WordList> hinges;
    Copies copies;

    // The table that names a file of sections; nullptr if there is none.
    const SectionFileTable* find_section_file() const {
        return sections ? std::get_if<SectionFileTable>(&*sections) : nullptr;
    }
};

// Returns whether the rod has a hinge at an end, "start" or "end".
bool has_hinge(const RodTable& table, std::string_view end);

// The rods of a deck, in its order.
std::vector<std::reference_wrapper<const RodTable>> rods_of(const CheckedTable& deck);

}  // namespace gxrod
