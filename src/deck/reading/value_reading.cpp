#include "deck/reading/value_reading.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "deck/reading/array_reading.hpp"
#include "deck/reading/word_reading.hpp"
#include "deck/schema/suggestion.hpp"
#include "machine/printable.hpp"

namespace gxrod {
namespace {

// Reads the value of one key; elements of arrays have their own place and path.
class ValueReader {
  public:
    ValueReader(const KeySpec& key, const ReadingContext& context) : key_(key), context_(context) {}

    std::optional<double> number(const DeckNode& node, const std::string& path) const {
        const std::optional<double> value = finite_number(node, path);
        return value ? in_range(node, path, *value) : std::nullopt;
    }

    // In the range of the key or not.
    std::optional<double> finite_number(const DeckNode& node, const std::string& path) const {
        std::optional<double> value;
        if (const auto* integer = std::get_if<std::int64_t>(&node.value)) {
            value = static_cast<double>(*integer);
        } else if (const auto* real = std::get_if<double>(&node.value)) {
            value = *real;
        } else if (const std::string* text = node.text()) {
            try {
                value = evaluate_constant(*text, context_.symbols);
            } catch (const ExpressionError& error) {
                add(node, path, fmt::format("\"{}\": {}", shorten(*text), error.what()));
            }
        } else {
            expect(node, path, number_expected());
        }
        if (!value) return std::nullopt;
        if (!std::isfinite(*value)) {
            add(node, path, "expected a finite number, found " + describe_found(node));
            return std::nullopt;
        }
        return value;
    }

    std::optional<long> integer(const DeckNode& node, const std::string& path) const {
        if (std::holds_alternative<double>(node.value)) {
            expect(node, path, describe_expected(key_));
            return std::nullopt;
        }
        if (node.text() == nullptr && !std::holds_alternative<std::int64_t>(node.value)) {
            expect(node, path, describe_expected(key_) + " or an expression");
            return std::nullopt;
        }
        const std::optional<double> value = number(node, path);
        if (!value) return std::nullopt;
        if (std::floor(*value) != *value) {
            add(node,
                path,
                fmt::format("expected {}, found {}", describe_expected(key_), found_value(node, *value)));
            return std::nullopt;
        }
        return static_cast<long>(*value);
    }

    std::optional<Vec3> vector(const DeckNode& node, const std::string& path) const {
        if (!is_array_of(node, 3)) {
            expect(node, path, describe_expected(key_));
            return std::nullopt;
        }
        Vec3 vector;
        bool complete = true;
        for (int i = 0; i < 3; ++i) {
            const auto component = number((*node.array())[i], fmt::format("{}[{}]", path, i));
            complete = complete && component;
            vector[i] = component.value_or(0.0);
        }
        return complete ? std::optional(vector) : std::nullopt;
    }

    std::optional<Mat3> square_matrix(const DeckNode& node, const std::string& path) const {
        if (is_array_of(node, 3)) return matrix(node, path);
        expect(node, path, describe_expected(key_));
        return std::nullopt;
    }

    std::optional<Mat3> matrix(const DeckNode& node, const std::string& path) const {
        const DeckNode::Array& rows = *node.array();
        Mat3 matrix;
        bool complete = true;
        for (int i = 0; i < 3; ++i) {
            const auto row = vector(rows[i], fmt::format("{}[{}]", path, i));
            complete = complete && row;
            matrix.row(i) = row.value_or(Vec3::Zero()).transpose();
        }
        return complete ? std::optional(matrix) : std::nullopt;
    }

    std::optional<CheckedTimeFunction> time_function(const DeckNode& node, const std::string& path) const {
        auto function = compiled<TimeFunction>(node, path, compile_time_function);
        if (!function) return std::nullopt;
        return CheckedTimeFunction{std::move(*function), node.place, path};
    }

    // f(t), or a table of them by name.
    std::optional<std::vector<CheckedNamedFunction>> named_functions(const DeckNode& node,
                                                                     const std::string& path) const {
        std::vector<CheckedNamedFunction> functions;
        bool complete = true;
        const auto read = [&](const std::string& name, const DeckNode& value, const std::string& at) {
            auto function = time_function(value, at);
            complete = complete && function;
            if (function) functions.push_back({name, std::move(*function)});
        };
        if (node.table() == nullptr) {
            read("", node, path);
        } else if (node.table()->empty()) {
            expect(node, path, describe_expected(key_));
            complete = false;
        } else {
            for (const DeckEntry& entry : *node.table()) read(entry.key, entry.node, path + "." + entry.key);
        }
        return complete ? std::optional(std::move(functions)) : std::nullopt;
    }

    std::optional<std::vector<CheckedNamedFunction>> coordinate_functions(const DeckNode& node,
                                                                          const std::string& path) const {
        if (node.table() == nullptr) return named_functions(node, path);
        bool complete = true;
        for (const DeckEntry& entry : *node.table()) {
            if (entry.key == "turn" || entry.key == "slide") continue;
            const std::string hint = did_you_mean(entry.key, {"turn", "slide"});
            context_.faults.add(entry.place,
                                path + "." + entry.key,
                                "unknown key" + (hint.empty() ? "; known here: turn, slide" : hint));
            complete = false;
        }
        return complete ? named_functions(node, path) : std::nullopt;
    }

    // A number, or f(s); its range is checked where it is evaluated.
    decltype(CheckedValue::value) arc_number(const DeckNode& node, const std::string& path) const {
        std::optional<double> value;
        if (node.text() == nullptr) {
            value = number(node, path);
        } else {
            try {
                const auto expression = compile_arc_function(*node.text(), path, context_.symbols);
                if (expression && expression->function) return CheckedArcFunction{expression->function};
                if (expression) value = in_range(node, path, expression->constant);
            } catch (const ExpressionError& error) {
                add(node, path, fmt::format("\"{}\": {}", shorten(*node.text()), error.what()));
            }
        }
        if (!value) return std::monostate{};
        return *value;
    }

    std::optional<CheckedLineFunction> line_function(const DeckNode& node, const std::string& path) const {
        auto expression = compiled<LineExpression>(node, path, compile_line_function);
        if (!expression) return std::nullopt;
        return CheckedLineFunction{std::move(*expression), node.place, path};
    }

    std::optional<CheckedPlaceFunction> place_function(const DeckNode& node, const std::string& path) const {
        auto expression = compiled<PlaceExpression>(node, path, compile_place_function);
        if (!expression) return std::nullopt;
        return CheckedPlaceFunction{std::move(*expression), node.place, path};
    }

    std::optional<CheckedMotionFunction> motion_function(const DeckNode& node,
                                                         const std::string& path) const {
        auto expression = compiled<MotionExpression>(node, path, compile_motion_function);
        if (!expression) return std::nullopt;
        return CheckedMotionFunction{std::move(*expression), node.place, path};
    }

    std::optional<CheckedMotionFunction> field_function(const DeckNode& node, const std::string& path) const {
        auto expression = compiled<MotionExpression>(node, path, compile_field_function);
        if (!expression) return std::nullopt;
        return CheckedMotionFunction{std::move(*expression), node.place, path};
    }

    std::optional<CheckedSpringFunction> spring_function(const DeckNode& node,
                                                         const std::string& path) const {
        auto expression = compiled<SpringExpression>(node, path, compile_spring_function);
        if (!expression) return std::nullopt;
        return CheckedSpringFunction{std::move(*expression), node.place, path};
    }

    // Functions, read by one of the members above.
    template <std::size_t Count, class Function>
    std::optional<std::array<Function, Count>> functions(
        const DeckNode& node,
        const std::string& path,
        std::optional<Function> (ValueReader::*read)(const DeckNode&, const std::string&) const) const {
        if (!is_array_of(node, Count)) {
            expect(node, path, describe_expected(key_));
            return std::nullopt;
        }
        std::array<Function, Count> vector;
        bool complete = true;
        for (std::size_t i = 0; i < Count; ++i) {
            auto component = (this->*read)((*node.array())[i], fmt::format("{}[{}]", path, i));
            complete = complete && component;
            if (component) vector[i] = std::move(*component);
        }
        return complete ? std::optional(std::move(vector)) : std::nullopt;
    }

    std::optional<TimeTable> time_table(const DeckNode& node, const std::string& path) const {
        if (node.array() == nullptr || node.array()->empty()) {
            expect(node, path, describe_expected(key_));
            return std::nullopt;
        }
        TimeTable table;
        bool complete = true;
        for (std::size_t i = 0; i < node.array()->size(); ++i) {
            const DeckNode& row = (*node.array())[i];
            const auto values = table_row(row, fmt::format("{}[{}]", path, i), "a row [t, value]");
            complete = complete && values;
            if (!complete) continue;
            if (!table.empty() && values->first <= table.back().first) {
                add(row,
                    fmt::format("{}[{}]", path, i),
                    fmt::format(
                        "t must increase from row to row: {} follows {}", values->first, table.back().first));
                complete = false;
            }
            table.push_back(*values);
        }
        return complete ? std::optional(std::move(table)) : std::nullopt;
    }

    std::optional<CheckedPairs> pairs(const DeckNode& node, const std::string& path) const {
        if (node.array() == nullptr || node.array()->empty()) {
            expect(node, path, describe_expected(key_));
            return std::nullopt;
        }
        CheckedPairs pairs;
        for (std::size_t i = 0; i < node.array()->size(); ++i) {
            const DeckNode& row = (*node.array())[i];
            const auto values = table_row(row, fmt::format("{}[{}]", path, i), "a row of 2 numbers");
            if (values) pairs.rows.push_back(*values);
            pairs.places.push_back(row.place);
        }
        return pairs.rows.size() == node.array()->size() ? std::optional(std::move(pairs)) : std::nullopt;
    }

    std::optional<bool> flag(const DeckNode& node, const std::string& path) const {
        if (const auto* value = std::get_if<bool>(&node.value)) return *value;
        expect(node, path, describe_expected(key_));
        return std::nullopt;
    }

    // From 0 to 1; where the same fraction stands twice, what follows it jumps. read(row, path, fraction)
    // takes what stands behind the fraction, and returns whether it is right.
    template <class Read>
    bool fractions(const DeckNode& node, const std::string& path, const Read& read) const {
        if (node.array() == nullptr || node.array()->size() < 2) {
            expect(node, path, describe_expected(key_));
            return false;
        }
        bool complete = true;
        std::optional<double> last;
        const std::size_t count = node.array()->size();
        for (std::size_t i = 0; i < count; ++i) {
            const DeckNode& row = (*node.array())[i];
            const std::string row_path = fmt::format("{}[{}]", path, i);
            if (!is_array_of(row, 2)) {
                expect(row, row_path, "a row of 2");
                complete = false;
                continue;
            }
            const std::optional<double> fraction = finite_number((*row.array())[0], row_path + "[0]");
            complete = fraction && read((*row.array())[1], row_path + "[1]", *fraction) && complete;
            if (!fraction) continue;
            const bool is_end = i == 0 || i + 1 == count;
            const double end = i == 0 ? 0.0 : 1.0;
            if (is_end && *fraction != end) {
                add(row, row_path, fmt::format("expected the fraction {} here, found {}", end, *fraction));
                complete = false;
            } else if (last && *fraction < *last) {
                add(row,
                    row_path,
                    fmt::format("fractions must not fall from row to row: {} follows {}", *fraction, *last));
                complete = false;
            }
            last = fraction;
        }
        return complete;
    }

    std::optional<CheckedProfile> profile(const DeckNode& node, const std::string& path) const {
        CheckedProfile profile;
        const auto read = [&](const DeckNode& value, const std::string& value_path, double fraction) {
            const std::optional<double> read_number = number(value, value_path);
            if (read_number) profile.rows.emplace_back(fraction, *read_number);
            return read_number.has_value();
        };
        return fractions(node, path, read) ? std::optional(std::move(profile)) : std::nullopt;
    }

    std::optional<std::vector<CheckedStation>> stations(const DeckNode& node, const std::string& path) const {
        std::vector<CheckedStation> stations;
        const auto read = [&](const DeckNode& name, const std::string& name_path, double fraction) {
            if (name.text() == nullptr) {
                expect(name, name_path, "the name of a section");
                return false;
            }
            stations.push_back({fraction, *name.text(), name.place, name_path});
            return true;
        };
        return fractions(node, path, read) ? std::optional(std::move(stations)) : std::nullopt;
    }

    // y and z as functions of s, or rows.
    std::optional<CheckedTendonPath> tendon_path(const DeckNode& node, const std::string& path) const {
        if (node.array() != nullptr && !node.array()->empty() && node.array()->front().array() != nullptr)
            return tendon_rows(node, path);
        if (!is_array_of(node, 2)) {
            expect(node, path, describe_expected(key_));
            return std::nullopt;
        }
        CheckedTendonPath checked;
        bool complete = true;
        for (std::size_t i = 0; i < 2; ++i) {
            auto value = arc_number((*node.array())[i], fmt::format("{}[{}]", path, i));
            if (auto* function = std::get_if<CheckedArcFunction>(&value)) {
                checked.functions[i] = std::move(function->function);
            } else if (const auto* constant = std::get_if<double>(&value)) {
                checked.functions[i] = [number = *constant](double) { return number; };
            } else {
                complete = false;
            }
        }
        return complete ? std::optional(std::move(checked)) : std::nullopt;
    }

    static bool is_array_of(const DeckNode& node, std::size_t size) {
        return node.array() != nullptr && node.array()->size() == size;
    }

    static bool is_matrix(const DeckNode& node) {
        return is_array_of(node, 3) &&
               std::any_of(node.array()->begin(), node.array()->end(), [](const DeckNode& row) {
                   return row.array() != nullptr;
               });
    }

  private:
    // An expression compiled, or a number.
    template <class Function, class Compile>
    std::optional<Function> compiled(const DeckNode& node,
                                     const std::string& path,
                                     const Compile& compile) const {
        if (const std::string* text = node.text()) {
            try {
                return compile(*text, path, context_.symbols);
            } catch (const ExpressionError& error) {
                add(node, path, fmt::format("\"{}\": {}", shorten(*text), error.what()));
            }
            return std::nullopt;
        }
        if (!std::holds_alternative<std::int64_t>(node.value) &&
            !std::holds_alternative<double>(node.value)) {
            expect(node, path, "a number or an expression in " + variables_of(key_.type));
            return std::nullopt;
        }
        const std::optional<double> value = number(node, path);
        if (!value) return std::nullopt;
        return constant<Function>(*value);
    }

    template <class Function>
    static Function constant(double value) {
        if constexpr (std::is_same_v<Function, PlaceExpression>) {
            return {[value](const Vec3&, double) { return value; }};
        } else if constexpr (std::is_same_v<Function, LineExpression>) {
            return {LineFunction(value)};
        } else if constexpr (std::is_same_v<Function, MotionExpression>) {
            return {.by_time = TimeFunction(value), .by_motion = {}};
        } else if constexpr (std::is_same_v<Function, SpringExpression>) {
            return {[value](double, double) { return value; }};
        } else {
            return TimeFunction(value);
        }
    }

    std::string remark() const { return key_.remark.empty() ? "" : "; " + key_.remark; }

    // Components of vectors and tables are described as bare numbers.
    std::string number_expected() const {
        return key_.type == ValueType::number || key_.type == ValueType::arc_number ||
                       key_.type == ValueType::number_or_pairs || key_.type == ValueType::number_or_table
                   ? describe_expected(key_)
                   : "a number or an expression";
    }

    void add(const DeckNode& node, const std::string& path, const std::string& message) const {
        context_.faults.add(node.place, path, message);
    }

    void expect(const DeckNode& node, const std::string& path, const std::string& expected) const {
        add(node, path, fmt::format("expected {}, found {}", expected, describe_found(node)));
    }

    // The number as the deck has it, and its value if it is an expression.
    static std::string found_value(const DeckNode& node, double value) {
        return node.text() == nullptr ? describe_found(node)
                                      : fmt::format("\"{}\" = {}", *node.text(), value);
    }

    std::optional<double> in_range(const DeckNode& node, const std::string& path, double value) const {
        if (key_.range.contains(value)) return value;
        const std::string kind = key_.type == ValueType::integer ? "an integer" : "a number";
        const std::string& above = key_.above_range;
        const std::string reason = value > key_.range.upper && !above.empty() ? "; " + above : remark();
        add(node,
            path,
            fmt::format("expected {} {}, found {}{}",
                        kind,
                        describe_range(key_.range),
                        found_value(node, value),
                        reason));
        return std::nullopt;
    }

    std::optional<CheckedTendonPath> tendon_rows(const DeckNode& node, const std::string& path) const {
        CheckedTendonPath checked;
        bool complete = node.array()->size() >= 2;
        if (!complete) expect(node, path, describe_expected(key_));
        for (std::size_t i = 0; i < node.array()->size(); ++i) {
            const DeckNode& row = (*node.array())[i];
            const std::string row_path = fmt::format("{}[{}]", path, i);
            if (!is_array_of(row, 3)) {
                expect(row, row_path, "a row [fraction, y, z]");
                complete = false;
                continue;
            }
            const std::optional<Vec3> values = vector(row, row_path);
            complete = complete && values;
            if (!values) continue;
            const double fraction = (*values)[0];
            const double last = checked.rows.empty() ? -1.0 : checked.rows.back()[0];
            if (fraction < 0.0 || fraction > 1.0 || fraction <= last) {
                add(row,
                    row_path,
                    fmt::format("fractions must increase from row to row, from 0 to 1; found {}", fraction));
                complete = false;
            }
            checked.rows.push_back({fraction, (*values)[1], (*values)[2]});
        }
        return complete ? std::optional(std::move(checked)) : std::nullopt;
    }

    std::optional<std::pair<double, double>> table_row(const DeckNode& row,
                                                       const std::string& path,
                                                       const std::string& expected) const {
        if (!is_array_of(row, 2)) {
            expect(row, path, expected);
            return std::nullopt;
        }
        const auto time = number((*row.array())[0], path + "[0]");
        const auto value = number((*row.array())[1], path + "[1]");
        if (!time || !value) return std::nullopt;
        return std::pair(*time, *value);
    }

    const KeySpec& key_;
    const ReadingContext& context_;
};

template <class Value>
decltype(CheckedValue::value) wrap(std::optional<Value> value) {
    if (!value) return std::monostate{};
    return std::move(*value);
}

}  // namespace

std::optional<double> read_number(const DeckNode& node,
                                  const std::string& path,
                                  const KeySpec& key,
                                  const ReadingContext& context) {
    return ValueReader(key, context).number(node, path);
}

decltype(CheckedValue::value) read_value(const DeckNode& node,
                                         const std::string& path,
                                         const KeySpec& key,
                                         const ReadingContext& context) {
    const ValueReader reader(key, context);
    switch (key.type) {
        case ValueType::text:
        case ValueType::reference:
        case ValueType::point:
            return wrap(read_text(node, path, key, context));
        case ValueType::choice:
            return wrap(read_word(node, path, key, context));
        case ValueType::choices:
            return wrap(read_words(node, path, key, context));
        case ValueType::names:
            return wrap(read_names(node, path, key, context));
        case ValueType::flag:
            return wrap(reader.flag(node, path));
        case ValueType::integer:
            return wrap(reader.integer(node, path));
        case ValueType::number:
        case ValueType::number_or_table:
            return wrap(reader.number(node, path));
        case ValueType::vector:
            return wrap(reader.vector(node, path));
        case ValueType::points:
        case ValueType::ends:
        case ValueType::joints:
        case ValueType::partners:
            return wrap(read_points(node, path, key, context));
        case ValueType::matrix:
            return wrap(reader.square_matrix(node, path));
        case ValueType::vectors:
            return wrap(read_vectors(node, path, key, context));
        case ValueType::section_point:
            return wrap(read_section_point(node, path, key, context));
        case ValueType::number_or_six:
            return wrap(read_number_or_six(node, path, key, context));
        case ValueType::numbers:
            return wrap(read_number_list(node, path, key, context));
        case ValueType::bounds:
            return wrap(read_bounds(node, path, key, context));
        case ValueType::section_matrix:
            return wrap(read_section_matrix(node, path, key, context));
        case ValueType::inertia:
            if (ValueReader::is_matrix(node)) return wrap(reader.matrix(node, path));
            return wrap(reader.vector(node, path));
        case ValueType::placement:
            if (node.text() != nullptr) return wrap(read_text(node, path, key, context));
            return wrap(reader.vector(node, path));
        case ValueType::mesh_group:
            return read_mesh_group(node, path, key, context);
        case ValueType::time_expression:
            return wrap(reader.time_function(node, path));
        case ValueType::stage_functions:
            return wrap(reader.named_functions(node, path));
        case ValueType::coordinate_functions:
            return wrap(reader.coordinate_functions(node, path));
        case ValueType::time_vector:
            return wrap(reader.functions<3>(node, path, &ValueReader::time_function));
        case ValueType::line_vector:
            return wrap(reader.functions<3>(node, path, &ValueReader::line_function));
        case ValueType::line_expression:
            return wrap(reader.line_function(node, path));
        case ValueType::line_pair:
            return wrap(reader.functions<2>(node, path, &ValueReader::line_function));
        case ValueType::field_vector:
            return wrap(reader.functions<3>(node, path, &ValueReader::field_function));
        case ValueType::tendon_path:
            return wrap(reader.tendon_path(node, path));
        case ValueType::place_vector:
            return wrap(reader.functions<3>(node, path, &ValueReader::place_function));
        case ValueType::motion_vector:
            return wrap(reader.functions<3>(node, path, &ValueReader::motion_function));
        case ValueType::spring_expression:
            return wrap(reader.spring_function(node, path));
        case ValueType::time_table:
            return wrap(reader.time_table(node, path));
        case ValueType::arc_number:
            return reader.arc_number(node, path);
        case ValueType::number_or_pairs:
            if (node.array() == nullptr) return wrap(reader.number(node, path));
            return wrap(reader.pairs(node, path));
        case ValueType::pairs:
            return wrap(reader.pairs(node, path));
        case ValueType::profile:
            if (node.array() == nullptr) return wrap(reader.number(node, path));
            return wrap(reader.profile(node, path));
        case ValueType::fraction_rows:
            return wrap(reader.profile(node, path));
        case ValueType::stations:
            return wrap(reader.stations(node, path));
        case ValueType::columns:
            return std::monostate{};  // read with their file, which is a table then
        default:
            assert(false);
            return std::monostate{};
    }
}

}  // namespace gxrod
