#include "deck/table/material_kinds.hpp"

#include <fmt/format.h>

#include "deck/reading/number_reader.hpp"

namespace gxrod {
namespace {

void expect_material_value(const DeckNode& node,
                           const std::string& path,
                           const std::string& expected,
                           const ReadingContext& context) {
    context.faults.add(
        node.place, path, fmt::format("expected {}, found {}", expected, describe_found(node)));
}

// Reads a ply, and whether its thickness is right; the times are an integer.
std::optional<CheckedPly> read_ply(const DeckNode& row,
                                   const std::string& path,
                                   const ReadingContext& context) {
    static const KeySpec any{};
    static const KeySpec times = [] {
        KeySpec key;
        key.range = {.lower = 1.0, .upper = 10'000.0};
        return key;
    }();
    const DeckNode::Array* items = row.array();
    if (items == nullptr || items->size() < 2 || items->size() > 4 || items->front().text() == nullptr) {
        expect_material_value(
            row,
            path,
            "a ply [\"material\", thickness, angle, times], of which angle and times can be left out",
            context);
        return std::nullopt;
    }
    CheckedPly ply{.material = {*items->front().text(), items->front().place, path + "[0]"}};
    const auto thickness = NumberReader(any, context).number((*items)[1], path + "[1]");
    const auto angle =
        items->size() > 2 ? NumberReader(any, context).number((*items)[2], path + "[2]") : std::optional(0.0);
    const auto count = items->size() > 3 ? NumberReader(times, context).number((*items)[3], path + "[3]")
                                         : std::optional(1.0);
    if (!thickness || !angle || !count) return std::nullopt;
    if (*thickness <= 0.0) {
        context.faults.add((*items)[1].place,
                           path + "[1]",
                           *thickness == 0.0
                               ? "the thickness is zero"
                               : fmt::format("expected a thickness greater than 0, found {}", *thickness));
        return std::nullopt;
    }
    ply.thickness = *thickness;
    ply.fibre_angle = *angle;
    ply.times = static_cast<long>(*count);
    if (static_cast<double>(ply.times) == *count) return ply;
    expect_material_value((*items)[3], path + "[3]", "an integer: how many times the ply is there", context);
    return std::nullopt;
}

}  // namespace

std::string Kind<AxisNumbers>::schema(const KeySpec& key) {
    return schema_of_any({number_schema(key), schema_of_list(number_schema(key), 1)});
}

std::optional<AxisNumbers> Kind<AxisNumbers>::read(const ValueSource& from) {
    const NumberReader reader(from.key, from.context);
    if (from.node.array() == nullptr) {
        const std::optional<double> number = reader.number(from.node, from.path);
        return number ? std::optional(AxisNumbers{{*number}}) : std::nullopt;
    }
    const DeckNode::Array& items = *from.node.array();
    if (items.empty() || items.size() > 3) {
        expect_material_value(from.node, from.path, words(from.key), from.context);
        return std::nullopt;
    }
    AxisNumbers value{.numbers = {}, .is_list = true};
    for (std::size_t i = 0; i < items.size(); ++i) {
        const auto number = reader.number(items[i], fmt::format("{}[{}]", from.path, i));
        if (number) value.numbers.push_back(*number);
    }
    return value.numbers.size() == items.size() ? std::optional(std::move(value)) : std::nullopt;
}

std::string Kind<AxisNumbers>::print(const AxisNumbers& value) {
    if (value.numbers.empty()) return "";
    return value.is_list ? Kind<std::vector<double>>::print(value.numbers)
                         : Kind<double>::print(value.numbers.front());
}

std::string Kind<PlyRows>::schema(const KeySpec&) {
    return fmt::format(
        R"({{"type": "array", "minItems": 1, "items": {{"type": "array", "prefixItems": [{0}, {1}, {1}, {1}], "minItems": 2, "maxItems": 4}}}})",
        text_schema,
        any_number_schema);
}

std::optional<PlyRows> Kind<PlyRows>::read(const ValueSource& from) {
    if (from.node.array() == nullptr || from.node.array()->empty()) {
        expect_material_value(from.node, from.path, words(from.key), from.context);
        return std::nullopt;
    }
    PlyRows rows;
    for (std::size_t i = 0; i < from.node.array()->size(); ++i) {
        auto ply = read_ply((*from.node.array())[i], fmt::format("{}[{}]", from.path, i), from.context);
        if (ply) rows.plies.push_back(std::move(*ply));
    }
    return rows.plies.size() == from.node.array()->size() ? std::optional(std::move(rows)) : std::nullopt;
}

std::string Kind<PlyRows>::print(const PlyRows& value) {
    std::vector<std::string> rows;
    for (const CheckedPly& ply : value.plies) {
        rows.push_back(fmt::format(
            "[\"{}\", {}, {}, {}]", ply.material.word, ply.thickness, ply.fibre_angle, ply.times));
    }
    return print_list(rows);
}

}  // namespace gxrod
