#include "deck/schema/schema.hpp"

#include <fmt/format.h>

#include <cmath>

#include "deck/schema/suggestion.hpp"
#include "deck/table/binding.hpp"

namespace gxrod {
bool Range::contains(double value) const {
    const bool above = at_lower == Bound::open ? value > lower : value >= lower;
    const bool below = at_upper == Bound::open ? value < upper : value <= upper;
    return above && below;
}

bool Range::is_unbounded() const { return std::isinf(lower) && std::isinf(upper); }

const KeySpec* TableSpec::find(std::string_view key) const {
    for (const KeySpec& spec : keys) {
        if (spec.name == key) return &spec;
    }
    return nullptr;
}

std::vector<std::string> TableSpec::key_names() const {
    std::vector<std::string> names;
    for (const KeySpec& key : keys) names.push_back(key.name);
    return names;
}

bool is_top_level_value(const TableSpec& root, std::string_view key) {
    const KeySpec* spec = root.find(key);
    return spec != nullptr && spec->table == nullptr;
}

std::string explain_misplaced_key(std::string_view key, std::string_view heading) {
    return fmt::format(
        "{} is a key of the top level and must come before the first [table]; here it belongs to {}",
        key,
        heading);
}

std::string describe_range(const Range& range) {
    const bool has_lower = std::isfinite(range.lower);
    const bool has_upper = std::isfinite(range.upper);
    if (has_lower && range.lower == range.upper) return fmt::format("equal to {}", range.lower);
    if (has_lower && has_upper && range.at_lower == Bound::closed && range.at_upper == Bound::closed) {
        return fmt::format("from {} to {}", range.lower, range.upper);
    }
    std::string text;
    if (has_lower) {
        text = fmt::format("{} {}", range.at_lower == Bound::open ? "greater than" : "at least", range.lower);
    }
    if (has_upper) {
        text += fmt::format("{}{} {}",
                            has_lower ? ", " : "",
                            range.at_upper == Bound::open ? "less than" : "at most",
                            range.upper);
    }
    return text;
}

std::string variables_of(const KeySpec& key) {
    const ValueKind* kind = find_kind(key);
    return kind != nullptr && kind->variables != nullptr ? kind->variables() : "t";
}

std::string spell(const KeySpec& key) {
    const bool is_table =
        key.table != nullptr && key.type != ValueType::bound && key.type != ValueType::number_or_table;
    return is_table ? key.table->heading : key.name;
}

std::string describe_expected(const KeySpec& key) {
    if (const ValueKind* kind = find_kind(key)) return kind->words(key);
    const std::string range = describe_range(key.range);
    const std::string ranged = range.empty() ? "" : " " + range;
    switch (key.type) {
        case ValueType::bound:
            break;
        case ValueType::text:
            return "text";
        case ValueType::reference:
            return fmt::format("the name of a {}", fmt::join(key.refers_to, " or "));
        case ValueType::point:
            return "a point, such as \"rod.end\", \"rod@0.25\" or \"body\"";
        case ValueType::points:
            return "an array of points, two at least, such as [\"leg.end\", \"beam.start\"]";
        case ValueType::ends:
            return "an array of 2 points, such as [\"arm.end\", \"body\"], or of one and \"ground\"";
        case ValueType::joints:
            return "an array of 2 joints, such as [\"motor\", \"wheel\"], or of their coordinates, such as "
                   "\"nut.slide\"";
        case ValueType::partners:
            return "an array of 2 names of rods and obstacles, such as [\"wire\", \"vessel\"], with * for "
                   "any "
                   "letters, or of a part of a rod, such as \"wire@0.9..1\"";
        case ValueType::choice:
            return (key.choices.size() > 1 ? "one of " : "") + quoted_list(key.choices);
        case ValueType::choices:
            return "one or a list of " + quoted_list(key.choices);
        case ValueType::names:
            return fmt::format("the name of a {0}, or an array of names", fmt::join(key.refers_to, " or "));
        case ValueType::flag:
            return "true or false";
        case ValueType::integer:
            return "an integer" + ranged;
        case ValueType::number:
            return "a number" + ranged + " or an expression";
        case ValueType::arc_number:
            return "a number" + ranged + " or an expression in s";
        case ValueType::vector:
            return "an array of 3 numbers or expressions";
        case ValueType::section_point:
            return "an array of 2 numbers or expressions, y and z";
        case ValueType::number_or_six:
            return "a number" + ranged + " or an expression, or an array of 6 of them";
        case ValueType::numbers:
            return "an array of numbers or expressions, one at least";
        case ValueType::pairs:
            return "an array of rows of 2 numbers or expressions, one at least";
        case ValueType::number_or_pairs:
            return "a number" + ranged + " or an expression, or an array of rows of 2";
        case ValueType::bounds:
            return "a number or an expression, or an array of 2: the lower and the upper bound";
        case ValueType::section_matrix:
            return "an array of 6 rows of 6 numbers or expressions";
        case ValueType::time_expression:
            return "a number or an expression in " + variables_of(key);
        case ValueType::time_vector:
            return "an array of 3 numbers or expressions in " + variables_of(key);
        case ValueType::time_table:
            return "an array of rows [t, value]";
        case ValueType::columns:
            return "an array of 2 names or numbers of columns, such as [\"t\", \"x\"] or [1, 3]";
        case ValueType::number_or_table:
            return "a number" + ranged + " or an expression, or a table " + key.table->heading;
        case ValueType::table:
        case ValueType::named_tables:
        case ValueType::parameters:
        case ValueType::variations:
            return "a table " + key.table->heading;
        case ValueType::table_list:
            return "tables " + key.table->heading;
    }
    return "";
}

}  // namespace gxrod
