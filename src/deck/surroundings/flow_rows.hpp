#pragma once

#include "deck/table/kinds.hpp"

// The table of a current or a wind.
namespace gxrod {

// Rows of a height and the flow there: a speed, a speed and its direction in degrees, or two or three
// components; all rows have as many numbers.
struct FlowRows {
    std::vector<std::vector<double>> rows;
    std::vector<Place> places;

    std::size_t width() const { return rows.front().size(); }
};

template <>
struct Kind<FlowRows> {
    static std::string words(const KeySpec&) {
        return "an array of rows [z, speed], [z, speed, degrees] or [z, vx, vy, vz], one at least";
    }
    static std::string column(const KeySpec&) { return "rows of 2, 3 or 4 numbers"; }
    static std::string schema(const KeySpec&);
    static std::optional<FlowRows> read(const ValueSource& from);
    static std::string print(const FlowRows& value);
    static std::string sample(const KeySpec&) { return "[[1, 2], [3, 4]]"; }
};

}  // namespace gxrod
