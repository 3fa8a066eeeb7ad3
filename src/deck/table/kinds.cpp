#include "deck/table/kinds.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "deck/reading/array_reading.hpp"
#include "deck/reading/row_reader.hpp"

namespace gxrod {
namespace {

constexpr const char* any_number = R"({"$ref": "#/$defs/number"})";
constexpr const char* any_expression = R"({"$ref": "#/$defs/expression"})";

// A number of the range that is seldom a default.
double sample_of(const Range& range) {
    if (std::isfinite(range.lower) && std::isfinite(range.upper))
        return 0.25 * range.lower + 0.75 * range.upper;
    return std::isfinite(range.upper) ? range.upper - 1.25
                                      : (std::isfinite(range.lower) ? range.lower : 0.0) + 1.25;
}

template <class Rows>
std::string print_rows(const Rows& rows) {
    std::vector<std::string> lines;
    for (Eigen::Index i = 0; i < rows.rows(); ++i) {
        std::vector<std::string> numbers;
        for (Eigen::Index j = 0; j < rows.cols(); ++j) numbers.push_back(Kind<double>::print(rows(i, j)));
        lines.push_back(print_list(numbers));
    }
    return print_list(lines);
}

std::string print_pairs(const std::vector<std::pair<double, double>>& rows) {
    std::vector<std::string> items;
    for (const auto& [first, second] : rows) items.push_back(fmt::format("[{}, {}]", first, second));
    return print_list(items);
}

std::string quote(const CheckedWord& word) { return "\"" + word.word + "\""; }

// A list, or its only word.
std::string print_words(const std::vector<CheckedWord>& words) {
    if (words.size() == 1) return quote(words.front());
    std::vector<std::string> items;
    for (const CheckedWord& word : words) items.push_back(quote(word));
    return print_list(items);
}

template <class Word>
std::optional<Word> read_one_word(const ValueSource& from) {
    const std::optional<std::string> text = read_text(from.node, from.path, from.key, from.context);
    return text ? std::optional(Word{{*text, from.node.place, from.path}}) : std::nullopt;
}

// Numbers of a range, as JSON Schema; `Number` is that of its bounds.
template <class Number>
std::string range_schema(const char* type, const Range& range) {
    nlohmann::ordered_json json{{"type", type}};
    if (std::isfinite(range.lower))
        json[range.at_lower == Bound::open ? "exclusiveMinimum" : "minimum"] =
            static_cast<Number>(range.lower);
    if (std::isfinite(range.upper))
        json[range.at_upper == Bound::open ? "exclusiveMaximum" : "maximum"] =
            static_cast<Number>(range.upper);
    return json.dump();
}

std::string any_schema_of(const std::vector<std::string>& schemas) {
    return fmt::format(R"({{"anyOf": [{}]}})", fmt::join(schemas, ", "));
}

// " greater than 0", or "".
std::string describe_after_blank(const Range& range) {
    const std::string text = describe_range(range);
    return text.empty() ? "" : " " + text;
}

}  // namespace

std::string number_words(const KeySpec& key) {
    return "a number" + describe_after_blank(key.range) + " or an expression";
}

std::string choice_words(const KeySpec& key) {
    return (key.choices.size() > 1 ? "one of " : "") + quoted_list(key.choices);
}

std::string number_schema(const KeySpec& key) {
    return any_schema_of({range_schema<double>("number", key.range), any_expression});
}

std::string choice_schema(const KeySpec& key) {
    return fmt::format(R"({{"enum": [{}]}})", quoted_list(key.choices));
}

std::string schema_of_one_or_list(const std::string& item) {
    return any_schema_of({item, schema_of_list(item, 1)});
}

std::string schema_of_list(const std::string& items, std::size_t least) {
    return fmt::format(R"({{"type": "array", "items": {}, "minItems": {}}})", items, least);
}

std::string schema_of_array(const std::string& items, std::size_t size) {
    return fmt::format(
        R"({{"type": "array", "items": {}, "minItems": {}, "maxItems": {}}})", items, size, size);
}

std::string print_list(const std::vector<std::string>& items) {
    return fmt::format("[{}]", fmt::join(items, ", "));
}

std::string spell_variables(std::span<const char* const> variables) {
    const std::string last = variables.back();
    const auto others = variables.first(variables.size() - 1);
    return others.empty() ? last : fmt::format("{} and {}", fmt::join(others, ", "), last);
}

std::string Kind<long>::words(const KeySpec& key) { return "an integer" + describe_after_blank(key.range); }

std::string Kind<long>::schema(const KeySpec& key) {
    return any_schema_of({range_schema<long>("integer", key.range), any_expression});
}

std::string Kind<CheckedPairs>::schema(const KeySpec&) {
    return schema_of_list(schema_of_array(any_number, 2), 1);
}

std::string Kind<std::vector<double>>::schema(const KeySpec&) { return schema_of_list(any_number, 1); }

std::string Kind<Bounds>::schema(const KeySpec&) {
    return any_schema_of({any_number, schema_of_array(any_number, 2)});
}

std::string Kind<std::variant<double, CheckedPairs>>::schema(const KeySpec& key) {
    return any_schema_of(
        {range_schema<double>("number", key.range), any_expression, Kind<CheckedPairs>::schema(key)});
}

std::string Kind<StrainTimes>::schema(const KeySpec& key) {
    return any_schema_of(
        {range_schema<double>("number", key.range), any_expression, schema_of_array(number_schema(key), 6)});
}

std::string Kind<std::array<double, 2>>::schema(const KeySpec&) { return schema_of_array(any_number, 2); }

std::string Kind<Vec3>::schema(const KeySpec&) { return schema_of_array(any_number, 3); }

std::string Kind<Mat6>::schema(const KeySpec&) { return schema_of_array(schema_of_array(any_number, 6), 6); }

std::optional<double> Kind<double>::read(const ValueSource& from) {
    return NumberReader(from.key, from.context).number(from.node, from.path);
}

std::string Kind<double>::sample(const KeySpec& key) { return print(sample_of(key.range)); }

std::optional<long> Kind<long>::read(const ValueSource& from) {
    return NumberReader(from.key, from.context).integer(from.node, from.path);
}

std::string Kind<long>::sample(const KeySpec& key) { return print(std::lround(sample_of(key.range))); }

std::optional<std::string> Kind<std::string>::read(const ValueSource& from) {
    return read_text(from.node, from.path, from.key, from.context);
}

std::optional<CheckedPairs> Kind<CheckedPairs>::read(const ValueSource& from) {
    return RowReader(from.key, from.context).pairs(from.node, from.path);
}

std::string Kind<CheckedPairs>::print(const CheckedPairs& value) { return print_pairs(value.rows); }

std::optional<std::vector<double>> Kind<std::vector<double>>::read(const ValueSource& from) {
    return read_number_list(from.node, from.path, from.key, from.context);
}

std::string Kind<std::vector<double>>::print(const std::vector<double>& value) {
    return fmt::format("[{}]", fmt::join(value, ", "));
}

std::optional<Bounds> Kind<Bounds>::read(const ValueSource& from) {
    auto numbers = read_bounds(from.node, from.path, from.key, from.context);
    return numbers ? std::optional(Bounds{std::move(*numbers)}) : std::nullopt;
}

std::optional<std::variant<double, CheckedPairs>> Kind<std::variant<double, CheckedPairs>>::read(
    const ValueSource& from) {
    const auto as_value = [](auto read) { return read ? std::optional<Value>(*read) : std::nullopt; };
    return from.node.array() == nullptr ? as_value(Kind<double>::read(from))
                                        : as_value(Kind<CheckedPairs>::read(from));
}

std::string Kind<std::variant<double, CheckedPairs>>::print(const Value& value) {
    return std::visit([]<class One>(const One& one) { return Kind<One>::print(one); }, value);
}

std::optional<ArcNumber> Kind<ArcNumber>::read(const ValueSource& from) {
    return FunctionReader(from.key, from.context).arc_number(from.node, from.path);
}

std::string Kind<ArcNumber>::print(const ArcNumber& value) {
    const auto* function = std::get_if<CheckedArcFunction>(&value);
    return Kind<double>::print(function == nullptr ? std::get<double>(value) : function->function(0.0));
}

std::optional<StrainTimes> Kind<StrainTimes>::read(const ValueSource& from) {
    auto times = read_number_or_six(from.node, from.path, from.key, from.context);
    return times ? std::optional(StrainTimes{std::move(*times)}) : std::nullopt;
}

std::string Kind<StrainTimes>::print(const StrainTimes& value) {
    std::vector<std::string> items;
    for (const double time : value.times) items.push_back(Kind<double>::print(time));
    return items.size() == 1 ? items.front() : print_list(items);
}

std::optional<std::array<double, 2>> Kind<std::array<double, 2>>::read(const ValueSource& from) {
    const auto point = read_section_point(from.node, from.path, from.key, from.context);
    return point ? std::optional(Value{(*point)[0], (*point)[1]}) : std::nullopt;
}

std::optional<bool> Kind<bool>::read(const ValueSource& from) {
    return NumberReader(from.key, from.context).flag(from.node, from.path);
}

std::optional<Vec3> Kind<Vec3>::read(const ValueSource& from) {
    return NumberReader(from.key, from.context).vector(from.node, from.path);
}

std::string Kind<Vec3>::print(const Vec3& value) {
    return fmt::format("[{}, {}, {}]", value[0], value[1], value[2]);
}

std::string Kind<Mat3>::schema(const KeySpec&) { return schema_of_array(schema_of_array(any_number, 3), 3); }

std::optional<Mat3> Kind<Mat3>::read(const ValueSource& from) {
    return NumberReader(from.key, from.context).square_matrix(from.node, from.path);
}

std::string Kind<Mat3>::print(const Mat3& value) { return print_rows(value); }

std::optional<Mat6> Kind<Mat6>::read(const ValueSource& from) {
    return read_section_matrix(from.node, from.path, from.key, from.context);
}

std::string Kind<Mat6>::print(const Mat6& value) { return print_rows(value); }

std::string Kind<Mat6>::sample(const KeySpec&) {
    return print_rows(Mat6(Vec6::LinSpaced(1.0, 6.0).asDiagonal()));
}

std::optional<PointName> Kind<PointName>::read(const ValueSource& from) {
    return read_one_word<PointName>(from);
}

std::optional<TableName> Kind<TableName>::read(const ValueSource& from) {
    return read_one_word<TableName>(from);
}

std::optional<TableNames> Kind<TableNames>::read(const ValueSource& from) {
    auto names = read_names(from.node, from.path, from.key, from.context);
    return names ? std::optional(TableNames{std::move(*names)}) : std::nullopt;
}

std::string Kind<TableNames>::print(const TableNames& value) { return print_words(value.names); }

std::optional<ChosenWord> Kind<ChosenWord>::read(const ValueSource& from) {
    auto word = read_word(from.node, from.path, from.key, from.context);
    return word ? std::optional(ChosenWord{std::move(*word)}) : std::nullopt;
}

std::optional<WordList> Kind<WordList>::read(const ValueSource& from) {
    auto words = read_words(from.node, from.path, from.key, from.context);
    return words ? std::optional(WordList{std::move(*words)}) : std::nullopt;
}

std::string Kind<WordList>::print(const WordList& value) { return print_words(value.words); }

std::string Kind<WordList>::sample(const KeySpec& key) {
    return fmt::format("[\"{}\", \"{}\"]", key.choices.front(), key.choices.back());
}

std::optional<Ends> Kind<Ends>::read(const ValueSource& from) {
    auto points = read_points(from.node, from.path, from.key, from.context);
    return points ? std::optional(Ends{{(*points)[0], (*points)[1]}}) : std::nullopt;
}

std::string Kind<Ends>::print(const Ends& value) { return print_list({quote(value[0]), quote(value[1])}); }

std::optional<JointNames> Kind<JointNames>::read(const ValueSource& from) {
    const char* one = "joint, such as \"wheel\"";
    auto joints = read_points(from.node, from.path, from.key, from.context, one);
    return joints ? std::optional(JointNames{{(*joints)[0], (*joints)[1]}}) : std::nullopt;
}

std::string Kind<JointNames>::print(const JointNames& value) {
    return print_list({quote(value[0]), quote(value[1])});
}

std::optional<Partners> Kind<Partners>::read(const ValueSource& from) {
    const char* one = "rod or an obstacle, such as \"wire\"";
    auto names = read_points(from.node, from.path, from.key, from.context, one);
    return names ? std::optional(Partners{{(*names)[0], (*names)[1]}}) : std::nullopt;
}

std::string Kind<Partners>::print(const Partners& value) {
    return print_list({quote(value[0]), quote(value[1])});
}

std::optional<PointList> Kind<PointList>::read(const ValueSource& from) {
    const std::size_t count = from.node.array() == nullptr ? 0 : from.node.array()->size();
    auto points = read_points(
        from.node, from.path, from.key, from.context, point_words, std::max<std::size_t>(count, 2));
    return points ? std::optional(PointList{std::move(*points)}) : std::nullopt;
}

std::string Kind<PointList>::print(const PointList& value) { return print_words(value.points); }

std::string Kind<std::variant<Vec3, Mat3>>::schema(const KeySpec& key) {
    return fmt::format(R"({{"anyOf": [{}, {}]}})", schema_of_array(any_number, 3), Kind<Mat3>::schema(key));
}

std::optional<std::variant<Vec3, Mat3>> Kind<std::variant<Vec3, Mat3>>::read(const ValueSource& from) {
    const auto as_value = [](auto read) { return read ? std::optional<Value>(*read) : std::nullopt; };
    const NumberReader reader(from.key, from.context);
    return NumberReader::is_matrix(from.node) ? as_value(reader.matrix(from.node, from.path))
                                              : as_value(reader.vector(from.node, from.path));
}

std::string Kind<std::variant<Vec3, Mat3>>::print(const Value& value) {
    return std::visit([]<class One>(const One& one) { return Kind<One>::print(one); }, value);
}

std::string Kind<std::variant<Vec3, PointName>>::schema(const KeySpec&) {
    return fmt::format(R"({{"anyOf": [{}, {{"type": "string"}}]}})", schema_of_array(any_number, 3));
}

std::optional<std::variant<Vec3, PointName>> Kind<std::variant<Vec3, PointName>>::read(
    const ValueSource& from) {
    const auto as_value = [](auto read) { return read ? std::optional<Value>(*read) : std::nullopt; };
    return from.node.text() != nullptr ? as_value(Kind<PointName>::read(from))
                                       : as_value(Kind<Vec3>::read(from));
}

std::string Kind<std::variant<Vec3, PointName>>::print(const Value& value) {
    return std::visit([]<class One>(const One& one) { return Kind<One>::print(one); }, value);
}

std::string Kind<FieldVector>::schema(const KeySpec&) { return schema_of_array(any_number, 3); }

std::optional<FieldVector> Kind<FieldVector>::read(const ValueSource& from) {
    auto components = FunctionReader(from.key, from.context)
                          .functions<3>(from.node, from.path, &FunctionReader::field_function);
    return components ? std::optional(FieldVector{std::move(*components)}) : std::nullopt;
}

std::string Kind<FieldVector>::print(const FieldVector& value) {
    return Kind<CheckedMotionVector>::print(value.components);
}

std::string Kind<CheckedTendonPath>::schema(const KeySpec&) {
    return fmt::format(R"({{"anyOf": [{}, {}]}})",
                       schema_of_array(any_number, 2),
                       schema_of_list(schema_of_array(any_number, 3), 2));
}

std::optional<CheckedTendonPath> Kind<CheckedTendonPath>::read(const ValueSource& from) {
    return RowReader(from.key, from.context).tendon_path(from.node, from.path);
}

std::string Kind<CheckedTendonPath>::print(const CheckedTendonPath& value) {
    std::vector<std::string> items;
    for (const auto& [fraction, y, z] : value.rows) items.push_back(Kind<Vec3>::print({fraction, y, z}));
    if (items.empty()) {
        for (const auto& function : value.functions)
            if (function) items.push_back(Kind<double>::print(function(0.0)));
    }
    return print_list(items);
}

std::string Kind<std::vector<CheckedVector>>::schema(const KeySpec&) {
    return schema_of_list(schema_of_array(any_number, 3), 2);
}

std::optional<std::vector<CheckedVector>> Kind<std::vector<CheckedVector>>::read(const ValueSource& from) {
    return read_vectors(from.node, from.path, from.key, from.context);
}

std::string Kind<std::vector<CheckedVector>>::print(const std::vector<CheckedVector>& value) {
    std::vector<std::string> items;
    for (const CheckedVector& one : value) items.push_back(Kind<Vec3>::print(one.value));
    return print_list(items);
}

std::string Kind<CheckedProfile>::words(const KeySpec& key) {
    const std::string range = describe_range(key.range);
    return fmt::format("an array of rows [fraction, number{}{}], two at least, from 0 to 1",
                       range.empty() ? "" : " ",
                       range);
}

std::string Kind<CheckedProfile>::schema(const KeySpec&) {
    return schema_of_list(schema_of_array(any_number, 2), 2);
}

std::optional<CheckedProfile> Kind<CheckedProfile>::read(const ValueSource& from) {
    return RowReader(from.key, from.context).profile(from.node, from.path);
}

std::string Kind<CheckedProfile>::print(const CheckedProfile& value) { return print_pairs(value.rows); }

std::string Kind<NumberAlong>::schema(const KeySpec& key) {
    return fmt::format(R"({{"anyOf": [{}, {}]}})", any_number, Kind<CheckedProfile>::schema(key));
}

std::optional<NumberAlong> Kind<NumberAlong>::read(const ValueSource& from) {
    const auto as_value = [](auto read) { return read ? std::optional<NumberAlong>(*read) : std::nullopt; };
    return from.node.array() == nullptr ? as_value(Kind<double>::read(from))
                                        : as_value(Kind<CheckedProfile>::read(from));
}

std::string Kind<NumberAlong>::print(const NumberAlong& value) {
    return std::visit([]<class One>(const One& one) { return Kind<One>::print(one); }, value);
}

std::string Kind<std::vector<CheckedStation>>::schema(const KeySpec&) {
    const std::string item = fmt::format(R"({{"anyOf": [{}, {{"type": "string"}}]}})", any_number);
    return schema_of_list(schema_of_array(item, 2), 2);
}

std::optional<std::vector<CheckedStation>> Kind<std::vector<CheckedStation>>::read(const ValueSource& from) {
    return RowReader(from.key, from.context).stations(from.node, from.path);
}

std::string Kind<std::vector<CheckedStation>>::print(const std::vector<CheckedStation>& value) {
    std::vector<std::string> items;
    for (const CheckedStation& one : value)
        items.push_back(print_list({Kind<double>::print(one.fraction), quote(one.section)}));
    return print_list(items);
}

std::optional<GroupName> Kind<GroupName>::read(const ValueSource& from) {
    if (const std::string* text = from.node.text()) return *text;
    if (const auto* number = std::get_if<std::int64_t>(&from.node.value)) return *number;
    from.context.faults.add(from.node.place,
                            from.path,
                            fmt::format("expected {}, found {}", words(from.key), describe_found(from.node)));
    return std::nullopt;
}

std::string Kind<GroupName>::print(const GroupName& value) {
    return std::visit([]<class One>(const One& one) { return Kind<One>::print(one); }, value);
}

std::string Kind<TimeTable>::schema(const KeySpec&) {
    return schema_of_list(schema_of_array(any_number, 2), 1);
}

std::optional<TimeTable> Kind<TimeTable>::read(const ValueSource& from) {
    return RowReader(from.key, from.context).time_table(from.node, from.path);
}

std::string Kind<TimeTable>::print(const TimeTable& value) { return print_pairs(value); }

std::optional<FileColumns> Kind<FileColumns>::read(const ValueSource& from) {
    const DeckNode::Array* items = from.node.array();
    if (items == nullptr || items->size() != 2) return std::nullopt;
    FileColumns columns;
    for (std::size_t i = 0; i < 2; ++i) {
        const DeckNode& item = (*items)[i];
        if (const auto* number = std::get_if<std::int64_t>(&item.value))
            columns[i] = *number;
        else if (item.text() != nullptr)
            columns[i] = *item.text();
        else
            return std::nullopt;
    }
    return columns;
}

std::string Kind<FileColumns>::print(const FileColumns& value) {
    std::vector<std::string> items;
    for (const auto& column : value)
        items.push_back(std::visit([]<class One>(const One& one) { return Kind<One>::print(one); }, column));
    return print_list(items);
}

std::string Kind<StageFunctions>::schema(const KeySpec&) {
    return fmt::format(
        R"({{"anyOf": [{0}, {{"type": "object", "patternProperties": {{"^[A-Za-z0-9_-]+$": {0}}}, "additionalProperties": false}}]}})",
        any_number);
}

std::optional<StageFunctions> Kind<StageFunctions>::read(const ValueSource& from) {
    return FunctionReader(from.key, from.context).named_functions(from.node, from.path);
}

std::string Kind<StageFunctions>::print(const StageFunctions& value) {
    std::vector<std::string> items;
    for (const CheckedNamedFunction& one : value)
        items.push_back(fmt::format("{} = {}", one.name, Kind<CheckedTimeFunction>::print(one.value)));
    return fmt::format("{{ {} }}", fmt::join(items, ", "));
}

std::string Kind<CoordinateFunctions>::schema(const KeySpec&) {
    return fmt::format(
        R"({{"anyOf": [{0}, {{"type": "object", "properties": {{"turn": {0}, "slide": {0}}}, "minProperties": 1, "additionalProperties": false}}]}})",
        any_number);
}

std::optional<CoordinateFunctions> Kind<CoordinateFunctions>::read(const ValueSource& from) {
    auto named = FunctionReader(from.key, from.context).coordinate_functions(from.node, from.path);
    return named ? std::optional(CoordinateFunctions{std::move(*named)}) : std::nullopt;
}

}  // namespace gxrod
