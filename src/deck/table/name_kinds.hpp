#pragma once

#include <fmt/format.h>

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "deck/reading/checked_deck.hpp"
#include "deck/reading/word_reading.hpp"
#include "deck/schema/choices.hpp"
#include "deck/schema/suggestion.hpp"
#include "deck/table/binding.hpp"
#include "deck/table/kind.hpp"
#include "deck/table/number_kinds.hpp"

// The kinds of texts, of names of other tables and of words.
namespace gxrod {

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

// The name or the number of a physical group of a mesh.
using GroupName = std::variant<std::string, long>;

// The columns of a file, by name or number. They are read with the file, whose rows replace them.
struct FileColumns : std::array<std::variant<std::string, long>, 2> {};

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
inline constexpr const std::array<Choice<WorkingShape>, 3>& choices_of(WorkingShape) {
    return working_shape_choices;
}
inline constexpr const std::array<Choice<YieldInteraction>, 2>& choices_of(YieldInteraction) {
    return yield_interaction_choices;
}

// Describes the words of a key, as messages do.
std::string choice_words(const KeySpec& key);
// The same, as JSON Schema.
std::string choice_schema(const KeySpec& key);

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

// Axes or a direction, or a word in their place.
template <class Other, HasWords Word>
struct KindOrWord {
    using Value = std::variant<Other, Word>;
    static std::vector<std::string> choices() { return Kind<Word>::choices(); }
    static std::string words(const KeySpec& key) {
        const bool is_one = key.choices.size() == 1;
        return Kind<Other>::words(key) + (is_one ? ", or " : ", or one of ") + quoted_list(key.choices);
    }
    static std::string column(const KeySpec& key) {
        return Kind<Other>::column(key) + ", or " + code_list(key.choices);
    }
    static std::string schema(const KeySpec& key) {
        return fmt::format(
            R"({{"anyOf": [{}, {{"enum": [{}]}}]}})", Kind<Other>::schema(key), quoted_list(key.choices));
    }
    static std::optional<Value> read(const ValueSource& from) {
        const auto as_value = [](auto read) { return read ? std::optional<Value>(*read) : std::nullopt; };
        return from.node.text() != nullptr ? as_value(Kind<Word>::read(from))
                                           : as_value(Kind<Other>::read(from));
    }
    static std::string print(const Value& value) {
        return std::visit([]<class One>(const One& one) { return Kind<One>::print(one); }, value);
    }
    static std::string sample(const KeySpec& key) { return Kind<Word>::sample(key); }
};

template <HasWords Word>
struct Kind<std::variant<Mat3, Word>> : KindOrWord<Mat3, Word> {};
template <HasWords Word>
struct Kind<std::variant<Vec3, Word>> : KindOrWord<Vec3, Word> {};

}  // namespace gxrod
