#pragma once

#include <optional>
#include <string>
#include <vector>

#include "deck/table/kind.hpp"
#include "deck/table/number_kinds.hpp"

// The kinds of materials and layups.
namespace gxrod {

// One number for all axes of a material, or several, by axis.
struct AxisNumbers {
    std::vector<double> numbers;
    bool is_list = false;
};

// A row ["material", thickness, fibre angle, times] of a layup.
struct CheckedPly {
    CheckedWord material;
    double thickness = 0.0, fibre_angle = 0.0;
    long times = 1;
};

struct PlyRows {
    std::vector<CheckedPly> plies;
};

template <>
struct Kind<AxisNumbers> {
    static std::string words(const KeySpec& key) {
        return number_words(key) + ", or an array of up to 3 of them";
    }
    static std::string column(const KeySpec&) { return "number or up to 3 numbers"; }
    static std::string schema(const KeySpec& key);
    static std::optional<AxisNumbers> read(const ValueSource& from);
    static std::string print(const AxisNumbers& value);
    static std::string sample(const KeySpec&) { return "[0.375, 0.25, 0.125]"; }
};

template <>
struct Kind<PlyRows> {
    static std::string words(const KeySpec&) {
        return "an array of plies [\"material\", thickness, angle, times], one at least";
    }
    static std::string column(const KeySpec&) { return "rows [material, thickness, angle, times]"; }
    static std::string schema(const KeySpec&);
    static std::optional<PlyRows> read(const ValueSource& from);
    static std::string print(const PlyRows& value);
    static std::string sample(const KeySpec&) {
        return "[[\"carbon\", 0.125, 0.5, 2], [\"carbon\", 0.25, 0, 1]]";
    }
};

}  // namespace gxrod
