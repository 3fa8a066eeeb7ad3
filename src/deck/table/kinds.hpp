#pragma once

#include <fmt/format.h>

#include <array>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "deck/reading/checked_deck.hpp"
#include "deck/reading/function_reader.hpp"
#include "deck/reading/word_reading.hpp"
#include "deck/schema/choices.hpp"
#include "deck/schema/suggestion.hpp"
#include "deck/table/binding.hpp"

// The types of values of a deck, each stated once: a key has the Kind of the C++ type of its field. A Kind<T>
// has
//   words, column, schema   what ValueKind says
//   nature                  optional: what ValueKind says
//   read                    the value of a text; nullopt, with a fault, if it is wrong
//   print                   the value as a deck has it
//   sample                  a value for tests
//   default_value           optional: what the schema shows as the default
namespace gxrod {

template <class Value>
struct Kind;

// A point, such as rod.end; that there is one is checked by check_points.
struct PointName : CheckedWord {};
// The name of a table elsewhere in the deck.
struct TableName : CheckedWord {};
// One such name, or several.
struct TableNames {
    std::vector<CheckedWord> names;
};
// One of the key's words.
struct ChosenWord {
    std::string word;
};
// One of the key's words, or several.
struct WordList {
    std::vector<CheckedWord> words;
};
// The two carriers of a spring or bushing: points, or the ground.
struct Ends : std::array<CheckedWord, 2> {};
// The coordinates of two joints.
struct JointNames : std::array<CheckedWord, 2> {};
// Two names of what touches, with * for any letters, or of parts of rods: wire@0.9..1.
struct Partners : std::array<CheckedWord, 2> {};
// Points, two at least.
struct PointList {
    std::vector<CheckedWord> points;
};
// A number, or a lower and an upper one.
struct Bounds {
    std::vector<double> numbers;
};
// A field by time and place.
struct FieldVector {
    CheckedMotionVector components;
};
// A number, or a function of the arc length along a rod.
using ArcNumber = std::variant<double, CheckedArcFunction>;
// One time for all strains of a section, or six.
struct StrainTimes {
    std::vector<double> times;
};
// A number, or rows of a fraction of a rod's length and a number.
using NumberAlong = std::variant<double, CheckedProfile>;
// The name or the number of a physical group of a mesh.
using GroupName = std::variant<std::string, long>;
// The columns of a file, by name or number. They are read with the file, whose rows replace them.
struct FileColumns : std::array<std::variant<std::string, long>, 2> {};
// Values by stage.
using StageFunctions = std::vector<CheckedNamedFunction>;
// Values of the turn and the slide of a joint.
struct CoordinateFunctions {
    std::vector<CheckedNamedFunction> named;
};

inline constexpr const std::array<Choice<ElementKind>, 2>& choices_of(ElementKind) {
    return element_kind_choices;
}
inline constexpr const std::array<Choice<ObstacleSide>, 2>& choices_of(ObstacleSide) {
    return obstacle_side_choices;
}
inline constexpr const std::array<Choice<Frame>, 3>& choices_of(Frame) { return frame_choices; }
inline constexpr const auto& choices_of(JointKind) { return joint_kind_choices; }
inline constexpr const std::array<Choice<BushingAxes>, 4>& choices_of(BushingAxes) {
    return bushing_axes_choices;
}

inline constexpr const std::array<Choice<Stretching>, 4>& choices_of(Stretching) {
    return stretching_choices;
}
inline constexpr const std::array<Choice<TendonEnd>, 2>& choices_of(TendonEnd) { return tendon_end_choices; }
inline constexpr const std::array<Choice<InputHold>, 2>& choices_of(InputHold) { return input_hold_choices; }
inline constexpr const std::array<Choice<LoadReference>, 1>& choices_of(LoadReference) {
    return load_reference_choices;
}
inline constexpr const std::array<Choice<Compression>, 2>& choices_of(Compression) {
    return compression_choices;
}
inline constexpr const std::array<Choice<Interpolation>, 3>& choices_of(Interpolation) {
    return interpolation_choices;
}
inline constexpr const std::array<Choice<PlaneAcross>, 3>& choices_of(PlaneAcross) { return plane_choices; }
inline constexpr const std::array<Choice<StrainPart>, 8>& choices_of(StrainPart) {
    return strain_part_choices;
}
inline constexpr const std::array<Choice<Hysteresis>, 2>& choices_of(Hysteresis) {
    return hysteresis_choices;
}
inline constexpr const std::array<Choice<YieldInteraction>, 2>& choices_of(YieldInteraction) {
    return yield_interaction_choices;
}

// Describes numbers and words of a key, as messages do.
std::string number_words(const KeySpec& key);
std::string choice_words(const KeySpec& key);
// A text, a number or a word of a key, as JSON Schema.
inline constexpr const char* text_schema = R"({"type": "string"})";
std::string number_schema(const KeySpec& key);
std::string choice_schema(const KeySpec& key);
// A value, or a list of them that is not empty, as JSON Schema.
std::string schema_of_one_or_list(const std::string& item);
// Arrays of so many values, as JSON Schema.
std::string schema_of_array(const std::string& items, std::size_t size);
// Arrays of so many values at least, as JSON Schema.
std::string schema_of_list(const std::string& items, std::size_t size);
// "[a, b, c]".
std::string print_list(const std::vector<std::string>& items);
// "t, x and y".
std::string spell_variables(std::span<const char* const> variables);

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
struct Kind<std::string> {
    static std::string words(const KeySpec&) { return "text"; }
    static std::string column(const KeySpec&) { return "text"; }
    static std::string schema(const KeySpec&) { return text_schema; }
    static std::optional<std::string> read(const ValueSource& from);
    static std::string print(const std::string& value) { return "\"" + value + "\""; }
    static std::string sample(const KeySpec&) { return "\"some text\""; }
    static std::string default_value(const std::string& value) { return value; }
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

template <>
struct Kind<PointName> {
    static std::string words(const KeySpec&) {
        return "a point, such as \"rod.end\", \"rod@0.25\" or \"body\"";
    }
    static std::string column(const KeySpec&) { return "point"; }
    static std::string schema(const KeySpec&) { return text_schema; }
    static std::optional<PointName> read(const ValueSource& from);
    static std::string print(const PointName& value) { return "\"" + value.word + "\""; }
    static std::string sample(const KeySpec&) { return "\"rod.end\""; }
};

template <>
struct Kind<TableName> {
    static std::string words(const KeySpec& key) {
        return fmt::format("the name of a {}", fmt::join(key.refers_to, " or "));
    }
    static std::string column(const KeySpec&) { return "name"; }
    static std::string schema(const KeySpec&) { return text_schema; }
    static std::optional<TableName> read(const ValueSource& from);
    static std::string print(const TableName& value) { return "\"" + value.word + "\""; }
    static std::string sample(const KeySpec&) { return "\"rod\""; }
};

template <>
struct Kind<TableNames> {
    static std::string words(const KeySpec& key) {
        return fmt::format("the name of a {}, or an array of names", fmt::join(key.refers_to, " or "));
    }
    static std::string column(const KeySpec&) { return "name or list of names"; }
    static std::string schema(const KeySpec&) { return schema_of_one_or_list(text_schema); }
    static std::optional<TableNames> read(const ValueSource& from);
    static std::string print(const TableNames& value);
    static std::string sample(const KeySpec&) { return "[\"first\", \"second\"]"; }
};

template <>
struct Kind<ChosenWord> {
    static constexpr ValueNature nature = ValueNature::word;
    static std::string words(const KeySpec& key) { return choice_words(key); }
    static std::string column(const KeySpec& key) { return code_list(key.choices); }
    static std::string schema(const KeySpec& key) { return choice_schema(key); }
    static std::optional<ChosenWord> read(const ValueSource& from);
    static std::string print(const ChosenWord& value) { return "\"" + value.word + "\""; }
    static std::string sample(const KeySpec& key) { return "\"" + key.choices.back() + "\""; }
};

template <>
struct Kind<WordList> {
    static std::string words(const KeySpec& key) { return "one or a list of " + quoted_list(key.choices); }
    static std::string column(const KeySpec& key) { return "one or a list of " + code_list(key.choices); }
    static std::string schema(const KeySpec& key) { return schema_of_one_or_list(choice_schema(key)); }
    static std::optional<WordList> read(const ValueSource& from);
    static std::string print(const WordList& value);
    static std::string sample(const KeySpec& key);
};

template <>
struct Kind<Ends> {
    static std::string words(const KeySpec&) {
        return "an array of 2 points, such as [\"arm.end\", \"body\"], or of one and \"ground\"";
    }
    static std::string column(const KeySpec&) { return "2 points, or a point and `\"ground\"`"; }
    static std::string schema(const KeySpec&) { return schema_of_array(text_schema, 2); }
    static std::optional<Ends> read(const ValueSource& from);
    static std::string print(const Ends& value);
    static std::string sample(const KeySpec&) { return "[\"rod.end\", \"ground\"]"; }
};

template <>
struct Kind<JointNames> {
    static std::string words(const KeySpec&) {
        return "an array of 2 joints, such as [\"motor\", \"wheel\"], or of their coordinates, such as "
               "\"nut.slide\"";
    }
    static std::string column(const KeySpec&) { return "2 joints, or `\"NAME.turn\"`, `\"NAME.slide\"`"; }
    static std::string schema(const KeySpec&) { return schema_of_array(text_schema, 2); }
    static std::optional<JointNames> read(const ValueSource& from);
    static std::string print(const JointNames& value);
    static std::string sample(const KeySpec&) { return "[\"wheel\", \"nut.slide\"]"; }
};

template <>
struct Kind<Partners> {
    static std::string words(const KeySpec&) {
        return "an array of 2 names of rods and obstacles, such as [\"wire\", \"vessel\"], with * for any "
               "letters, or of a part of a rod, such as \"wire@0.9..1\"";
    }
    static std::string column(const KeySpec&) { return "2 names with `*`, or `\"ROD@FROM..TO\"`"; }
    static std::string schema(const KeySpec&) { return schema_of_array(text_schema, 2); }
    static std::optional<Partners> read(const ValueSource& from);
    static std::string print(const Partners& value);
    static std::string sample(const KeySpec&) { return "[\"wire@0.9..1\", \"vessel\"]"; }
};

template <>
struct Kind<PointList> {
    static std::string words(const KeySpec&) {
        return "an array of points, two at least, such as [\"leg.end\", \"beam.start\"]";
    }
    static std::string column(const KeySpec&) { return "points"; }
    static std::string schema(const KeySpec&) { return schema_of_list(text_schema, 2); }
    static std::optional<PointList> read(const ValueSource& from);
    static std::string print(const PointList& value);
    static std::string sample(const KeySpec&) { return "[\"rod.end\", \"other.start\"]"; }
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

// A place, or a point that is there.
template <>
struct Kind<std::variant<Vec3, PointName>> {
    using Value = std::variant<Vec3, PointName>;
    static std::string words(const KeySpec&) {
        return "an array of 3 numbers or expressions, or a point such as \"rod.end\"";
    }
    static std::string column(const KeySpec&) { return "vector or point"; }
    static std::string schema(const KeySpec&);
    static std::optional<Value> read(const ValueSource& from);
    static std::string print(const Value& value);
    static std::string sample(const KeySpec& key) { return Kind<PointName>::sample(key); }
    static Vec3 default_value(const Value& value) { return std::get<Vec3>(value); }
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

// By the arc length, or rows.
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

// Stations along a rod; the key can have a table in their place.
template <>
struct Kind<std::vector<CheckedStation>> {
    static std::string words(const KeySpec&) {
        return "an array of rows [fraction, \"section\"], two at least, from 0 to 1, or a table { file = "
               "\"…\" }";
    }
    static std::string column(const KeySpec&) { return "rows [fraction, section], or table"; }
    static std::string schema(const KeySpec&);
    static std::optional<std::vector<CheckedStation>> read(const ValueSource& from);
    static std::string print(const std::vector<CheckedStation>& value);
    static std::string sample(const KeySpec&) { return "[[0, \"first\"], [1, \"second\"]]"; }
};

template <>
struct Kind<GroupName> {
    static std::string words(const KeySpec&) { return "the name or the number of a physical group"; }
    static std::string column(const KeySpec&) { return "name or number"; }
    static std::string schema(const KeySpec&) { return R"({"type": ["string", "integer"]})"; }
    static std::optional<GroupName> read(const ValueSource& from);
    static std::string print(const GroupName& value);
    static std::string sample(const KeySpec&) { return "22"; }
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

template <>
struct Kind<FileColumns> {
    static std::string words(const KeySpec&) {
        return "an array of 2 names or numbers of columns, such as [\"t\", \"x\"] or [1, 3]";
    }
    static std::string column(const KeySpec&) { return "2 names or numbers"; }
    static std::string schema(const KeySpec&) {
        return schema_of_array(R"({"type": ["string", "integer"]})", 2);
    }
    // Adds no faults.
    static std::optional<FileColumns> read(const ValueSource& from);
    static std::string print(const FileColumns& value);
    static std::string sample(const KeySpec&) { return "[\"t\", 3]"; }
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

template <class Value>
concept HasWords = requires(Value value) { choices_of(value); };

// One of some words.
template <HasWords Word>
struct Kind<Word> {
    static constexpr ValueNature nature = ValueNature::word;
    static std::string words(const KeySpec& key) { return choice_words(key); }
    static std::string column(const KeySpec& key) { return code_list(key.choices); }
    static std::string schema(const KeySpec& key) { return choice_schema(key); }
    static std::vector<std::string> choices() { return words_of(choices_of(Word{})); }
    static std::optional<Word> read(const ValueSource& from) {
        const std::optional<std::string> word = read_word(from.node, from.path, from.key, from.context);
        return word ? std::optional(value_of(choices_of(Word{}), *word)) : std::nullopt;
    }
    static std::string print(Word value) { return "\"" + word_of(choices_of(Word{}), value) + "\""; }
    static std::string sample(const KeySpec& key) { return "\"" + key.choices.back() + "\""; }
    static std::string default_value(Word value) { return word_of(choices_of(Word{}), value); }
};

// Axes, or a word for where they are.
template <class Word>
struct Kind<std::variant<Mat3, Word>> {
    using Value = std::variant<Mat3, Word>;
    static std::vector<std::string> choices() { return Kind<Word>::choices(); }
    static std::string words(const KeySpec& key) {
        return Kind<Mat3>::words(key) + ", or one of " + quoted_list(key.choices);
    }
    static std::string column(const KeySpec& key) {
        return Kind<Mat3>::column(key) + ", or " + code_list(key.choices);
    }
    static std::string schema(const KeySpec& key) {
        return fmt::format(
            R"({{"anyOf": [{}, {{"enum": [{}]}}]}})", Kind<Mat3>::schema(key), quoted_list(key.choices));
    }
    static std::optional<Value> read(const ValueSource& from) {
        const auto as_value = [](auto read) { return read ? std::optional<Value>(*read) : std::nullopt; };
        return from.node.text() != nullptr ? as_value(Kind<Word>::read(from))
                                           : as_value(Kind<Mat3>::read(from));
    }
    static std::string print(const Value& value) {
        return std::visit([]<class One>(const One& one) { return Kind<One>::print(one); }, value);
    }
    static std::string sample(const KeySpec& key) { return Kind<Word>::sample(key); }
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
    static constexpr std::array variables{"t", "x", "y", "z", "vx", "vy", "vz"};
    static constexpr auto read = &FunctionReader::motion_function;
    static double value(const CheckedMotionFunction& of) { return of.expression.by_time(0.0); }
};

template <>
struct FunctionKind<CheckedSpringFunction> {
    static constexpr std::array variables{"length", "rate"};
    static constexpr auto read = &FunctionReader::spring_function;
    static double value(const CheckedSpringFunction& of) { return of.expression.function(0.0, 0.0); }
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

template <class Value>
constexpr ValueKind make_kind() {
    ValueKind kind{.words = &Kind<Value>::words,
                   .column = &Kind<Value>::column,
                   .schema = &Kind<Value>::schema,
                   .sample = &Kind<Value>::sample};
    if constexpr (requires { Kind<Value>::nature; }) kind.nature = Kind<Value>::nature;
    if constexpr (requires { Kind<Value>::variables(); }) kind.variables = &Kind<Value>::variables;
    return kind;
}

template <class Value>
inline constexpr ValueKind value_kind = make_kind<Value>();

}  // namespace gxrod
