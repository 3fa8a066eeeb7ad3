#include "deck/table/function_kinds.hpp"

#include <fmt/ranges.h>

#include "deck/reading/row_reader.hpp"

namespace gxrod {

std::string spell_variables(std::span<const char* const> variables) {
    const std::string last = variables.back();
    const auto others = variables.first(variables.size() - 1);
    return others.empty() ? last : fmt::format("{} and {}", fmt::join(others, ", "), last);
}

std::optional<ArcNumber> Kind<ArcNumber>::read(const ValueSource& from) {
    return FunctionReader(from.key, from.context).arc_number(from.node, from.path);
}

std::string Kind<ArcNumber>::print(const ArcNumber& value) {
    const auto* function = std::get_if<CheckedArcFunction>(&value);
    return Kind<double>::print(function == nullptr ? std::get<double>(value) : function->function(0.0));
}

std::string Kind<FieldVector>::schema(const KeySpec&) { return schema_of_array(any_number_schema, 3); }

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
                       schema_of_array(any_number_schema, 2),
                       schema_of_list(schema_of_array(any_number_schema, 3), 2));
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

std::string Kind<StageFunctions>::schema(const KeySpec&) {
    return fmt::format(
        R"({{"anyOf": [{0}, {{"type": "object", "patternProperties": {{"^[A-Za-z0-9_-]+$": {0}}}, "additionalProperties": false}}]}})",
        any_number_schema);
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
        any_number_schema);
}

std::optional<CoordinateFunctions> Kind<CoordinateFunctions>::read(const ValueSource& from) {
    auto named = FunctionReader(from.key, from.context).coordinate_functions(from.node, from.path);
    return named ? std::optional(CoordinateFunctions{std::move(*named)}) : std::nullopt;
}

}  // namespace gxrod
