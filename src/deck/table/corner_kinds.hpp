#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cross_section/outlines/outline.hpp"
#include "deck/table/binding.hpp"
#include "deck/table/kind.hpp"

// The kinds of polygons: rows [y, z] or [y, z, radius].
namespace gxrod {

struct CheckedCorner {
    OutlineCorner corner;
    Place place;
};

// The corners of a closed chain.
struct CornerRows {
    std::vector<CheckedCorner> corners;
    Place place;
};

// Several chains.
struct CornerRowLists {
    std::vector<CornerRows> chains;
};

template <>
struct Kind<CornerRows> {
    static std::string words(const KeySpec&) {
        return "an array of corners [y, z] or [y, z, radius], two at least";
    }
    static std::string column(const KeySpec&) { return "rows [y, z] or [y, z, radius]"; }
    static std::string schema(const KeySpec&);
    static std::optional<CornerRows> read(const ValueSource& from);
    static std::string print(const CornerRows& value);
    static std::string sample(const KeySpec&) { return "[[0, 0], [4, 0, 0.5], [0, 3]]"; }
};

template <>
struct Kind<CornerRowLists> {
    static std::string words(const KeySpec&) {
        return "an array of arrays of corners [y, z] or [y, z, radius]";
    }
    static std::string column(const KeySpec&) { return "arrays of rows [y, z] or [y, z, radius]"; }
    static std::string schema(const KeySpec&);
    static std::optional<CornerRowLists> read(const ValueSource& from);
    static std::string print(const CornerRowLists& value);
    static std::string sample(const KeySpec&) { return "[[[0.5, 0.5], [1, 0.5], [0.5, 1]]]"; }
};

}  // namespace gxrod
