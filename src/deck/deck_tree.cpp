#include "deck/deck_tree.hpp"

#include <toml++/toml.h>

#include <algorithm>
#include <sstream>

#include "deck/syntax_fault.hpp"

namespace gxrod {
namespace {

Place place_of(const toml::source_region& region) {
    return {-1, static_cast<int>(region.begin.line), static_cast<int>(region.begin.column)};
}

DeckNode convert(const toml::node& node);

// toml++ sorts keys by name; their places bring the deck's order back.
DeckNode::Table convert_table(const toml::table& table) {
    DeckNode::Table entries;
    for (const auto& [key, node] : table) {
        entries.push_back({std::string(key.str()), place_of(key.source()), convert(node)});
    }
    std::stable_sort(entries.begin(), entries.end(), [](const DeckEntry& a, const DeckEntry& b) {
        return a.place < b.place;
    });
    return entries;
}

DeckNode::Array convert_array(const toml::array& array) {
    DeckNode::Array elements;
    for (const toml::node& node : array) elements.push_back(convert(node));
    return elements;
}

template <class Date>
DeckDate convert_date(const Date& date) {
    std::ostringstream text;
    text << date;
    return {text.str()};
}

DeckNode convert(const toml::node& node) {
    DeckNode result;
    result.place = place_of(node.source());
    node.visit([&result](const auto& value) {
        using Value = std::decay_t<decltype(value)>;
        if constexpr (toml::is_table<Value>)
            result.value = convert_table(value);
        else if constexpr (toml::is_array<Value>)
            result.value = convert_array(value);
        else if constexpr (toml::is_date<Value> || toml::is_time<Value> || toml::is_date_time<Value>)
            result.value = convert_date(value.get());
        else
            result.value = value.get();
    });
    return result;
}

}  // namespace

const DeckEntry* DeckNode::find(std::string_view key) const {
    for (const DeckEntry& entry : std::get<Table>(value)) {
        if (entry.key == key) return &entry;
    }
    return nullptr;
}

DeckEntry* DeckNode::find(std::string_view key) {
    return const_cast<DeckEntry*>(static_cast<const DeckNode*>(this)->find(key));
}

DeckNode read_toml(std::string_view text, const std::string& file) {
    try {
        const toml::table table = toml::parse(text, std::string_view(file));
        return {convert_table(table), {}};
    } catch (const toml::parse_error& error) {
        throw DeckError({explain_syntax_fault(text, file, place_of(error.source()), error.description())});
    }
}

}  // namespace gxrod
