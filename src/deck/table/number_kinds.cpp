#include "deck/table/number_kinds.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "deck/reading/array_reading.hpp"
#include "deck/reading/row_reader.hpp"
#include "deck/reading/word_reading.hpp"

namespace gxrod {
namespace {

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

// " greater than 0", or "".
std::string describe_after_blank(const Range& range) {
    const std::string text = describe_range(range);
    return text.empty() ? "" : " " + text;
}

}  // namespace

std::string number_words(const KeySpec& key) {
    return "a number" + describe_after_blank(key.range) + " or an expression";
}

std::string number_schema(const KeySpec& key) {
    return schema_of_any({range_schema<double>("number", key.range), any_expression});
}

std::string print_pairs(const std::vector<std::pair<double, double>>& rows) {
    std::vector<std::string> items;
    for (const auto& [first, second] : rows) items.push_back(fmt::format("[{}, {}]", first, second));
    return print_list(items);
}

std::string Kind<long>::words(const KeySpec& key) { return "an integer" + describe_after_blank(key.range); }

std::string Kind<long>::schema(const KeySpec& key) {
    return schema_of_any({range_schema<long>("integer", key.range), any_expression});
}

std::string Kind<CheckedPairs>::schema(const KeySpec&) {
    return schema_of_list(schema_of_array(any_number_schema, 2), 1);
}

std::string Kind<std::vector<double>>::schema(const KeySpec&) { return schema_of_list(any_number_schema, 1); }

std::string Kind<Bounds>::schema(const KeySpec&) {
    return schema_of_any({any_number_schema, schema_of_array(any_number_schema, 2)});
}

std::string Kind<std::variant<double, CheckedPairs>>::schema(const KeySpec& key) {
    return schema_of_any(
        {range_schema<double>("number", key.range), any_expression, Kind<CheckedPairs>::schema(key)});
}

std::string Kind<StrainTimes>::schema(const KeySpec& key) {
    return schema_of_any(
        {range_schema<double>("number", key.range), any_expression, schema_of_array(number_schema(key), 6)});
}

std::string Kind<std::array<double, 2>>::schema(const KeySpec&) {
    return schema_of_array(any_number_schema, 2);
}

std::string Kind<Vec3>::schema(const KeySpec&) { return schema_of_array(any_number_schema, 3); }

std::string Kind<Mat6>::schema(const KeySpec&) {
    return schema_of_array(schema_of_array(any_number_schema, 6), 6);
}

std::optional<double> Kind<double>::read(const ValueSource& from) {
    return NumberReader(from.key, from.context).number(from.node, from.path);
}

std::string Kind<double>::sample(const KeySpec& key) { return print(sample_of(key.range)); }

std::optional<long> Kind<long>::read(const ValueSource& from) {
    return NumberReader(from.key, from.context).integer(from.node, from.path);
}

std::string Kind<long>::sample(const KeySpec& key) { return print(std::lround(sample_of(key.range))); }

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

std::string Kind<Mat3>::schema(const KeySpec&) {
    return schema_of_array(schema_of_array(any_number_schema, 3), 3);
}

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

std::string Kind<std::variant<Vec3, Mat3>>::schema(const KeySpec& key) {
    return fmt::format(
        R"({{"anyOf": [{}, {}]}})", schema_of_array(any_number_schema, 3), Kind<Mat3>::schema(key));
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

std::string Kind<std::vector<CheckedVector>>::schema(const KeySpec&) {
    return schema_of_list(schema_of_array(any_number_schema, 3), 2);
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
    return schema_of_list(schema_of_array(any_number_schema, 2), 2);
}

std::optional<CheckedProfile> Kind<CheckedProfile>::read(const ValueSource& from) {
    return RowReader(from.key, from.context).profile(from.node, from.path);
}

std::string Kind<CheckedProfile>::print(const CheckedProfile& value) { return print_pairs(value.rows); }

std::string Kind<NumberAlong>::schema(const KeySpec& key) {
    return fmt::format(R"({{"anyOf": [{}, {}]}})", any_number_schema, Kind<CheckedProfile>::schema(key));
}

std::optional<NumberAlong> Kind<NumberAlong>::read(const ValueSource& from) {
    const auto as_value = [](auto read) { return read ? std::optional<NumberAlong>(*read) : std::nullopt; };
    return from.node.array() == nullptr ? as_value(Kind<double>::read(from))
                                        : as_value(Kind<CheckedProfile>::read(from));
}

std::string Kind<NumberAlong>::print(const NumberAlong& value) {
    return std::visit([]<class One>(const One& one) { return Kind<One>::print(one); }, value);
}

std::string Kind<TimeTable>::schema(const KeySpec&) {
    return schema_of_list(schema_of_array(any_number_schema, 2), 1);
}

std::optional<TimeTable> Kind<TimeTable>::read(const ValueSource& from) {
    return RowReader(from.key, from.context).time_table(from.node, from.path);
}

std::string Kind<TimeTable>::print(const TimeTable& value) { return print_pairs(value); }

}  // namespace gxrod
