#include "deck/schema/schema.hpp"

#include <fmt/format.h>

#include <cmath>

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
    return spec != nullptr && spec->shape == KeyShape::value;
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
    if (key.shape == KeyShape::named_tables && key.binding) return key.name + " = { NAME = { … } }";
    return key.shape == KeyShape::value ? key.name : key.table->heading;
}

std::string describe_expected(const KeySpec& key) {
    if (key.takes_one) return "a table " + spell(key) + " or a list of them";
    if (key.shape == KeyShape::table_list) return "tables " + key.table->heading;
    if (key.shape != KeyShape::value) return "a table " + spell(key);
    const std::string words = find_kind(key)->words(key);
    const bool has_table =
        key.table != nullptr && (nature_of(key) == ValueNature::number ||
                                 nature_of(key) == ValueNature::word || !key.refers_to.empty());
    return has_table ? words + ", or a table " + key.table->heading : words;
}

}  // namespace gxrod
