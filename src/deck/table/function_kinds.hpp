#pragma once

#include <fmt/format.h>

#include <array>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "deck/reading/checked_deck.hpp"
#include "deck/reading/function_reader.hpp"
#include "deck/table/binding.hpp"
#include "deck/table/kind.hpp"
#include "deck/table/number_kinds.hpp"

// The kinds of functions of time and place.
namespace gxrod {

// A field by time and place.
struct FieldVector {
    CheckedMotionVector components;
};

// A number, or a function of the arc length along a rod.
using ArcNumber = std::variant<double, CheckedArcFunction>;

// Values by stage.
using StageFunctions = std::vector<CheckedNamedFunction>;

// Values of the turn and the slide of a joint.
struct CoordinateFunctions {
    std::vector<CheckedNamedFunction> named;
};

// "t, x and y".
std::string spell_variables(std::span<const char* const> variables);

template <>
struct Kind<ArcNumber> {
    static constexpr ValueNature nature = ValueNature::number;
    static std::string words(const KeySpec& key) { return number_words(key) + " in s"; }
    static std::string column(const KeySpec&) { return "number or f(s)"; }
    static std::string schema(const KeySpec& key) { return number_schema(key); }
    static std::optional<ArcNumber> read(const ValueSource& from);
    static std::string print(const ArcNumber& value);
    static std::string sample(const KeySpec& key) { return Kind<double>::sample(key); }
    static double default_value(const ArcNumber& value) { return std::get<double>(value); }
};

template <>
struct Kind<FieldVector> {
    static std::string variables() { return "t, x, y and z"; }
    static std::string words(const KeySpec&) {
        return "an array of 3 numbers or expressions in " + variables();
    }
    static std::string column(const KeySpec&) { return "3 f(t, x, y, z)"; }
    static std::string schema(const KeySpec&);
    static std::optional<FieldVector> read(const ValueSource& from);
    static std::string print(const FieldVector& value);
    static std::string sample(const KeySpec&) { return "[1.25, 2.5, 3.75]"; }
};

// The path of a tendon: functions of the arc length, or rows.
template <>
struct Kind<CheckedTendonPath> {
    static std::string words(const KeySpec&) {
        return "an array of 2 numbers or expressions in s, or of rows [fraction, y, z], two at least";
    }
    static std::string column(const KeySpec&) { return "2 f(s), or rows [fraction, y, z]"; }
    static std::string schema(const KeySpec&);
    static std::optional<CheckedTendonPath> read(const ValueSource& from);
    static std::string print(const CheckedTendonPath& value);
    static std::string sample(const KeySpec&) { return "[[0.25, 1, 2], [0.75, 3, 4]]"; }
};

template <>
struct Kind<StageFunctions> {
    static std::string words(const KeySpec&) {
        return "a number or an expression in t, or a table of one for each stage, such as { hang = \"t\", "
               "swing = 1 }";
    }
    static std::string column(const KeySpec&) { return "f(t), or { STAGE = f(t) }"; }
    static std::string schema(const KeySpec&);
    static std::optional<StageFunctions> read(const ValueSource& from);
    static std::string print(const StageFunctions& value);
    static std::string sample(const KeySpec&) { return "{ first = 1.25, second = 2.5 }"; }
};

template <>
struct Kind<CoordinateFunctions> {
    static std::string words(const KeySpec&) {
        return "a number or an expression in t, or a table { turn = \"…\", slide = \"…\" } of them";
    }
    static std::string column(const KeySpec&) { return "f(t), or { turn = f(t), slide = f(t) }"; }
    static std::string schema(const KeySpec&);
    static std::optional<CoordinateFunctions> read(const ValueSource& from);
    static std::string print(const CoordinateFunctions& value) {
        return Kind<StageFunctions>::print(value.named);
    }
    static std::string sample(const KeySpec&) { return "{ turn = 1.25, slide = 2.5 }"; }
};

// An expression or a number: its variables, how it is read, and its value for printing, which shows constants
// alone.
template <class Function>
struct FunctionKind {};

template <>
struct FunctionKind<CheckedTimeFunction> {
    static constexpr std::array variables{"t"};
    static constexpr auto read = &FunctionReader::time_function;
    static double value(const CheckedTimeFunction& of) { return of.function(0.0); }
};

template <>
struct FunctionKind<CheckedLineFunction> {
    static constexpr std::array variables{"t", "s"};
    static constexpr auto read = &FunctionReader::line_function;
    static double value(const CheckedLineFunction& of) { return of.expression.function(0.0, 0.0); }
};

template <>
struct FunctionKind<CheckedPlaceFunction> {
    static constexpr std::array variables{"x", "y", "z", "s"};
    static constexpr auto read = &FunctionReader::place_function;
    static double value(const CheckedPlaceFunction& of) { return of.expression.function(Vec3::Zero(), 0.0); }
};

template <>
struct FunctionKind<CheckedMotionFunction> {
    static constexpr std::array variables{
        "t", "x", "y", "z", "vx", "vy", "vz", "rx", "ry", "rz", "wx", "wy", "wz"};
    static constexpr auto read = &FunctionReader::motion_function;
    static double value(const CheckedMotionFunction& of) { return of.expression.by_time(0.0); }
};

template <>
struct FunctionKind<CheckedLineMotionFunction> {
    static constexpr std::array variables{
        "t", "s", "x", "y", "z", "vx", "vy", "vz", "rx", "ry", "rz", "wx", "wy", "wz"};
    static constexpr auto read = &FunctionReader::line_motion_function;
    static double value(const CheckedLineMotionFunction& of) {
        return of.expression.by_line.function(0.0, 0.0);
    }
};

template <>
struct FunctionKind<CheckedSpringFunction> {
    static constexpr std::array variables{"length", "rate"};
    static constexpr auto read = &FunctionReader::spring_function;
    static double value(const CheckedSpringFunction& of) { return of.expression.function(0.0, 0.0); }
};

template <>
struct FunctionKind<CheckedAngleFunction> {
    static constexpr std::array variables{"angle"};
    static constexpr auto read = &FunctionReader::angle_function;
    static double value(const CheckedAngleFunction& of) { return of.expression.function(0.0); }
};

template <class Function>
concept IsFunction = requires { FunctionKind<Function>::variables; };

template <IsFunction Function>
struct Kind<Function> {
    using Own = FunctionKind<Function>;
    static std::string variables() { return spell_variables(Own::variables); }
    static std::string words(const KeySpec&) { return "a number or an expression in " + variables(); }
    static std::string column(const KeySpec&) {
        return fmt::format("f({})", fmt::join(Own::variables, ", "));
    }
    static std::string schema(const KeySpec&) { return R"({"$ref": "#/$defs/number"})"; }
    static std::optional<Function> read(const ValueSource& from) {
        return (FunctionReader(from.key, from.context).*Own::read)(from.node, from.path);
    }
    static std::string print(const Function& value) { return Kind<double>::print(Own::value(value)); }
    static std::string sample(const KeySpec&) { return "1.25"; }
};

template <IsFunction Function, std::size_t count>
struct Kind<std::array<Function, count>> {
    using Own = FunctionKind<Function>;
    using Value = std::array<Function, count>;
    static std::string variables() { return spell_variables(Own::variables); }
    static std::string words(const KeySpec&) {
        return fmt::format("an array of {} numbers or expressions in {}", count, variables());
    }
    static std::string column(const KeySpec& key) {
        return fmt::format("{} {}", count, Kind<Function>::column(key));
    }
    static std::string schema(const KeySpec& key) {
        return schema_of_array(Kind<Function>::schema(key), count);
    }
    static std::optional<Value> read(const ValueSource& from) {
        return FunctionReader(from.key, from.context).functions<count>(from.node, from.path, Own::read);
    }
    static std::string print(const Value& value) {
        std::vector<std::string> items;
        for (const Function& one : value) items.push_back(Kind<Function>::print(one));
        return print_list(items);
    }
    static std::string sample(const KeySpec& key) {
        return print_list(std::vector<std::string>(count, Kind<Function>::sample(key)));
    }
};

}  // namespace gxrod
