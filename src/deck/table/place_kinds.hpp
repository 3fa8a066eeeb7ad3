#pragma once

#include <optional>
#include <string>
#include <vector>

#include "deck/reading/checked_deck.hpp"
#include "deck/table/binding.hpp"
#include "deck/table/kind.hpp"

// The kinds of keys that name several places.
namespace gxrod {

// Points, or patterns of points in which * stands for any letters.
struct PointPatterns {
    std::vector<CheckedWord> words;
};

// Points that become one node, patterns of them, or the word for all that coincide.
struct ConnectedPoints {
    std::vector<CheckedWord> words;

    bool are_coincident() const { return words.size() == 1 && words.front().word == "coincident"; }
};

// A condition on places of the reference shape.
struct PlaceCondition {
    CheckedPlaceFunction value;
    std::string text;  // as the deck has it

    bool holds(const Vec3& position, double s) const { return value.expression.function(position, s) != 0.0; }
};

template <>
struct Kind<PointPatterns> {
    static std::string words(const KeySpec&) {
        return "a point, such as \"rod.end\", \"rod@0.25\" or \"body\", with * for any letters, or an array "
               "of "
               "points";
    }
    static std::string column(const KeySpec&) { return "point or list of points, with `*`"; }
    static std::string schema(const KeySpec&) { return schema_of_one_or_list(text_schema); }
    static std::optional<PointPatterns> read(const ValueSource& from);
    static std::string print(const PointPatterns& value);
    static std::string sample(const KeySpec&) { return "[\"rod.end\", \"pile*.start\"]"; }
};

template <>
struct Kind<ConnectedPoints> {
    static std::string words(const KeySpec&) {
        return "an array of points, such as [\"leg.end\", \"beam.start\"], with * for any letters, or "
               "\"coincident\"";
    }
    static std::string column(const KeySpec&) { return "points, with `*`, or `\"coincident\"`"; }
    static std::string schema(const KeySpec&) {
        return schema_of_any({schema_of_list(text_schema, 1), R"({"const": "coincident"})"});
    }
    static std::optional<ConnectedPoints> read(const ValueSource& from);
    static std::string print(const ConnectedPoints& value);
    static std::string sample(const KeySpec&) { return "[\"rod.end\", \"other.start\"]"; }
};

template <>
struct Kind<PlaceCondition> {
    static std::string words(const KeySpec&) {
        return "a condition in x, y, z and s, such as \"z == 0 && x < 2\"";
    }
    static std::string column(const KeySpec&) { return "condition in x, y, z, s"; }
    static std::string schema(const KeySpec&) { return text_schema; }
    static std::optional<PlaceCondition> read(const ValueSource& from);
    static std::string print(const PlaceCondition& value) { return "\"" + value.text + "\""; }
    static std::string sample(const KeySpec&) { return "\"z == 0\""; }
};

}  // namespace gxrod
