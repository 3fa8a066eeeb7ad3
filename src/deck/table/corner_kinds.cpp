#include "deck/table/corner_kinds.hpp"

#include <fmt/format.h>

#include "deck/reading/number_reader.hpp"
#include "deck/table/number_kinds.hpp"

namespace gxrod {
namespace {

constexpr const char* one_corner = "a corner [y, z] or [y, z, radius]";

void expect_corners(const DeckNode& node,
                    const std::string& path,
                    const std::string& expected,
                    const ReadingContext& context) {
    context.faults.add(
        node.place, path, fmt::format("expected {}, found {}", expected, describe_found(node)));
}

std::optional<CheckedCorner> read_corner(const DeckNode& node,
                                         const std::string& path,
                                         const ReadingContext& context) {
    static const KeySpec coordinate{};
    static const KeySpec radius = [] {
        KeySpec key;
        key.range.lower = 0.0;
        return key;
    }();
    if (!NumberReader::is_array_of(node, 2) && !NumberReader::is_array_of(node, 3)) {
        expect_corners(node, path, one_corner, context);
        return std::nullopt;
    }
    std::vector<double> numbers;
    for (std::size_t i = 0; i < node.array()->size(); ++i) {
        const auto number = NumberReader(i < 2 ? coordinate : radius, context)
                                .number((*node.array())[i], fmt::format("{}[{}]", path, i));
        if (number) numbers.push_back(*number);
    }
    if (numbers.size() != node.array()->size()) return std::nullopt;
    return CheckedCorner{{{numbers[0], numbers[1]}, numbers.size() == 3 ? numbers[2] : 0.0}, node.place};
}

std::optional<CornerRows> read_corners(const DeckNode& node,
                                       const std::string& path,
                                       const ValueSource& from) {
    if (node.array() == nullptr) {
        expect_corners(node, path, Kind<CornerRows>::words(from.key), from.context);
        return std::nullopt;
    }
    CornerRows rows{.corners = {}, .place = node.place};
    for (std::size_t i = 0; i < node.array()->size(); ++i) {
        const auto corner = read_corner((*node.array())[i], fmt::format("{}[{}]", path, i), from.context);
        if (corner) rows.corners.push_back(*corner);
    }
    return rows.corners.size() == node.array()->size() ? std::optional(std::move(rows)) : std::nullopt;
}

}  // namespace

std::string Kind<CornerRows>::schema(const KeySpec&) {
    return schema_of_list(
        schema_of_any({schema_of_array(any_number_schema, 2), schema_of_array(any_number_schema, 3)}), 2);
}

std::optional<CornerRows> Kind<CornerRows>::read(const ValueSource& from) {
    return read_corners(from.node, from.path, from);
}

std::string Kind<CornerRows>::print(const CornerRows& value) {
    std::vector<std::string> rows;
    for (const auto& [corner, place] : value.corners) {
        std::vector<std::string> numbers{Kind<double>::print(corner.at.x()),
                                         Kind<double>::print(corner.at.y())};
        if (corner.radius != 0.0) numbers.push_back(Kind<double>::print(corner.radius));
        rows.push_back(print_list(numbers));
    }
    return print_list(rows);
}

std::string Kind<CornerRowLists>::schema(const KeySpec& key) {
    return schema_of_list(Kind<CornerRows>::schema(key), 0);
}

std::optional<CornerRowLists> Kind<CornerRowLists>::read(const ValueSource& from) {
    if (from.node.array() == nullptr) {
        expect_corners(from.node, from.path, words(from.key), from.context);
        return std::nullopt;
    }
    CornerRowLists lists;
    for (std::size_t i = 0; i < from.node.array()->size(); ++i) {
        auto rows = read_corners((*from.node.array())[i], fmt::format("{}[{}]", from.path, i), from);
        if (rows) lists.chains.push_back(std::move(*rows));
    }
    return lists.chains.size() == from.node.array()->size() ? std::optional(std::move(lists)) : std::nullopt;
}

std::string Kind<CornerRowLists>::print(const CornerRowLists& value) {
    std::vector<std::string> chains;
    for (const CornerRows& chain : value.chains) chains.push_back(Kind<CornerRows>::print(chain));
    return print_list(chains);
}

}  // namespace gxrod
