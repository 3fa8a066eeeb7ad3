#pragma once

#include <fmt/format.h>

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "deck/reading/checked_deck.hpp"
#include "deck/table/binding.hpp"
#include "deck/table/kind.hpp"

// The kinds of numbers, vectors, matrices and rows of numbers.
namespace gxrod {

// A number, or a lower and an upper one.
struct Bounds {
    std::vector<double> numbers;
};

// One time for all strains of a section, or six.
struct StrainTimes {
    std::vector<double> times;
};

// A number, or rows of a fraction of a rod's length and a number.
using NumberAlong = std::variant<double, CheckedProfile>;

// Describes numbers of a key, as messages do.
std::string number_words(const KeySpec& key);
// The same, as JSON Schema.
std::string number_schema(const KeySpec& key);
// "[[a, b], [c, d]]".
std::string print_pairs(const std::vector<std::pair<double, double>>& rows);

template <>
struct Kind<double> {
    static constexpr ValueNature nature = ValueNature::number;
    static std::string words(const KeySpec& key) { return number_words(key); }
    static std::string column(const KeySpec&) { return "number"; }
    static std::string schema(const KeySpec& key) { return number_schema(key); }
    static std::optional<double> read(const ValueSource& from);
    static std::string print(double value) { return fmt::format("{}", value); }
    static std::string sample(const KeySpec& key);
    static double default_value(double value) { return value; }
};

template <>
struct Kind<long> {
    static constexpr ValueNature nature = ValueNature::integer;
    static std::string words(const KeySpec& key);
    static std::string column(const KeySpec&) { return "integer"; }
    static std::string schema(const KeySpec& key);
    static std::optional<long> read(const ValueSource& from);
    static std::string print(long value) { return fmt::format("{}", value); }
    static std::string sample(const KeySpec& key);
    static long default_value(long value) { return value; }
};

template <>
struct Kind<CheckedPairs> {
    static std::string words(const KeySpec&) {
        return "an array of rows of 2 numbers or expressions, one at least";
    }
    static std::string column(const KeySpec&) { return "rows of 2 numbers"; }
    static std::string schema(const KeySpec&);
    static std::optional<CheckedPairs> read(const ValueSource& from);
    static std::string print(const CheckedPairs& value);
    static std::string sample(const KeySpec&) { return "[[1, 2], [3, 4]]"; }
};

template <>
struct Kind<std::vector<double>> {
    static std::string words(const KeySpec&) { return "an array of numbers or expressions, one at least"; }
    static std::string column(const KeySpec&) { return "numbers"; }
    static std::string schema(const KeySpec&);
    static std::optional<std::vector<double>> read(const ValueSource& from);
    static std::string print(const std::vector<double>& value);
    static std::string sample(const KeySpec&) { return "[1.25, 2.5]"; }
};

template <>
struct Kind<Bounds> {
    static std::string words(const KeySpec&) {
        return "a number or an expression, or an array of 2: the lower and the upper bound";
    }
    static std::string column(const KeySpec&) { return "number or 2 numbers"; }
    static std::string schema(const KeySpec&);
    static std::optional<Bounds> read(const ValueSource& from);
    static std::string print(const Bounds& value) { return Kind<std::vector<double>>::print(value.numbers); }
    static std::string sample(const KeySpec& key) { return Kind<std::vector<double>>::sample(key); }
};

template <>
struct Kind<std::variant<double, CheckedPairs>> {
    using Value = std::variant<double, CheckedPairs>;
    static constexpr ValueNature nature = ValueNature::number;
    static std::string words(const KeySpec& key) { return number_words(key) + ", or an array of rows of 2"; }
    static std::string column(const KeySpec&) { return "number or rows of 2"; }
    static std::string schema(const KeySpec& key);
    static std::optional<Value> read(const ValueSource& from);
    static std::string print(const Value& value);
    static std::string sample(const KeySpec& key) { return Kind<CheckedPairs>::sample(key); }
};

template <>
struct Kind<StrainTimes> {
    static std::string words(const KeySpec& key) { return number_words(key) + ", or an array of 6 of them"; }
    static std::string column(const KeySpec&) { return "number or 6 numbers"; }
    static std::string schema(const KeySpec& key);
    static std::optional<StrainTimes> read(const ValueSource& from);
    static std::string print(const StrainTimes& value);
    static std::string sample(const KeySpec&) { return "[1, 2, 3, 4, 5, 6]"; }
};

// y and z of a section.
template <>
struct Kind<std::array<double, 2>> {
    using Value = std::array<double, 2>;
    static std::string words(const KeySpec&) { return "an array of 2 numbers or expressions, y and z"; }
    static std::string column(const KeySpec&) { return "2 numbers"; }
    static std::string schema(const KeySpec&);
    static std::optional<Value> read(const ValueSource& from);
    static std::string print(const Value& value) { return fmt::format("[{}, {}]", value[0], value[1]); }
    static std::string sample(const KeySpec&) { return "[1.25, 2.5]"; }
};

template <>
struct Kind<bool> {
    static std::string words(const KeySpec&) { return "true or false"; }
    static std::string column(const KeySpec&) { return "true or false"; }
    static std::string schema(const KeySpec&) { return R"({"type": "boolean"})"; }
    static std::optional<bool> read(const ValueSource& from);
    static std::string print(bool value) { return value ? "true" : "false"; }
    static std::string sample(const KeySpec&) { return "false"; }
};

template <>
struct Kind<Vec3> {
    static std::string words(const KeySpec&) { return "an array of 3 numbers or expressions"; }
    static std::string column(const KeySpec&) { return "vector"; }
    static std::string schema(const KeySpec&);
    static std::optional<Vec3> read(const ValueSource& from);
    static std::string print(const Vec3& value);
    static std::string sample(const KeySpec&) { return "[1.25, 2.5, 3.75]"; }
    static Vec3 default_value(const Vec3& value) { return value; }
};

template <>
struct Kind<Mat3> {
    static std::string words(const KeySpec&) { return "an array of 3 rows of 3 numbers or expressions"; }
    static std::string column(const KeySpec&) { return "3×3"; }
    static std::string schema(const KeySpec& key);
    static std::optional<Mat3> read(const ValueSource& from);
    static std::string print(const Mat3& value);
    static std::string sample(const KeySpec&) { return "[[1, 2, 3], [4, 5, 6], [7, 8, 9]]"; }
};

template <>
struct Kind<Mat6> {
    static std::string words(const KeySpec&) { return "an array of 6 rows of 6 numbers or expressions"; }
    static std::string column(const KeySpec&) { return "6×6"; }
    static std::string schema(const KeySpec&);
    static std::optional<Mat6> read(const ValueSource& from);
    static std::string print(const Mat6& value);
    static std::string sample(const KeySpec&);
};

// Three principal moments, or a matrix.
template <>
struct Kind<std::variant<Vec3, Mat3>> {
    using Value = std::variant<Vec3, Mat3>;
    static std::string words(const KeySpec&) {
        return "an array of 3 numbers or expressions, or of 3 such arrays";
    }
    static std::string column(const KeySpec&) { return "vector or 3×3"; }
    static std::string schema(const KeySpec& key);
    static std::optional<Value> read(const ValueSource& from);
    static std::string print(const Value& value);
    static std::string sample(const KeySpec& key) { return Kind<Mat3>::sample(key); }
};

template <>
struct Kind<std::vector<CheckedVector>> {
    static std::string words(const KeySpec&) {
        return "an array of 2 vectors or more, each of 3 numbers or expressions";
    }
    static std::string column(const KeySpec&) { return "2 vectors or more"; }
    static std::string schema(const KeySpec&);
    static std::optional<std::vector<CheckedVector>> read(const ValueSource& from);
    static std::string print(const std::vector<CheckedVector>& value);
    static std::string sample(const KeySpec&) { return "[[1, 2, 3], [4, 5, 6]]"; }
};

template <>
struct Kind<CheckedProfile> {
    static std::string words(const KeySpec& key);
    static std::string column(const KeySpec&) { return "rows [fraction, number]"; }
    static std::string schema(const KeySpec&);
    static std::optional<CheckedProfile> read(const ValueSource& from);
    static std::string print(const CheckedProfile& value);
    static std::string sample(const KeySpec&) { return "[[0, 1.25], [1, 2.5]]"; }
};

template <>
struct Kind<NumberAlong> {
    static std::string words(const KeySpec&) {
        return "a number or an expression, or an array of rows [fraction, number], from 0 to 1";
    }
    static std::string column(const KeySpec&) { return "number or rows [fraction, number]"; }
    static std::string schema(const KeySpec& key);
    static std::optional<NumberAlong> read(const ValueSource& from);
    static std::string print(const NumberAlong& value);
    static std::string sample(const KeySpec& key) { return Kind<CheckedProfile>::sample(key); }
    static double default_value(const NumberAlong& value) { return std::get<double>(value); }
};

template <>
struct Kind<TimeTable> {
    static std::string words(const KeySpec&) { return "an array of rows [t, value]"; }
    static std::string column(const KeySpec&) { return "rows [t, value]"; }
    static std::string schema(const KeySpec&);
    static std::optional<TimeTable> read(const ValueSource& from);
    static std::string print(const TimeTable& value);
    static std::string sample(const KeySpec&) { return "[[1, 2], [3, 4]]"; }
};

}  // namespace gxrod
