#include "deck/table/place_kinds.hpp"

#include <fmt/format.h>

#include "deck/expressions/near_comparisons.hpp"
#include "deck/reading/function_reader.hpp"
#include "deck/reading/word_reading.hpp"
#include "deck/schema/suggestion.hpp"

namespace gxrod {
namespace {

std::vector<std::string> quote_all(const std::vector<CheckedWord>& words) {
    std::vector<std::string> items;
    for (const CheckedWord& word : words) items.push_back("\"" + word.word + "\"");
    return items;
}

}  // namespace

std::optional<PointPatterns> Kind<PointPatterns>::read(const ValueSource& from) {
    auto words = read_names(from.node, from.path, from.key, from.context);
    return words ? std::optional(PointPatterns{std::move(*words)}) : std::nullopt;
}

std::string Kind<PointPatterns>::print(const PointPatterns& value) {
    const std::vector<std::string> items = quote_all(value.words);
    return items.size() == 1 ? items.front() : print_list(items);
}

std::optional<ConnectedPoints> Kind<ConnectedPoints>::read(const ValueSource& from) {
    auto words = read_names(from.node, from.path, from.key, from.context);
    if (!words) return std::nullopt;
    ConnectedPoints points{std::move(*words)};
    const bool is_pattern = points.words.front().word.find('*') != std::string::npos;
    if (points.words.size() > 1 || is_pattern || points.are_coincident()) return points;
    from.context.faults.add(
        from.node.place,
        from.path,
        fmt::format(
            "expected {}, found {}", Kind<ConnectedPoints>::words(from.key), describe_found(from.node)));
    return std::nullopt;
}

std::string Kind<ConnectedPoints>::print(const ConnectedPoints& value) {
    return value.are_coincident() ? "\"coincident\"" : print_list(quote_all(value.words));
}

std::optional<PlaceCondition> Kind<PlaceCondition>::read(const ValueSource& from) {
    const std::optional<std::string> text = read_text(from.node, from.path, from.key, from.context);
    if (!text) return std::nullopt;
    const FunctionReader reader(from.key, from.context);
    // Mistakes are those of the expression as it is written.
    if (!reader.place_function(from.node, from.path)) return std::nullopt;
    auto near = reader.place_function({compare_nearly(*text), from.node.place}, from.path);
    return near ? std::optional(PlaceCondition{std::move(*near), *text}) : std::nullopt;
}

}  // namespace gxrod
