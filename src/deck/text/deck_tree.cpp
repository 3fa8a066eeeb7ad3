#include "deck/text/deck_tree.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cctype>
#include <sstream>

#include "deck/text/syntax_fault.hpp"
#include "machine/printable.hpp"

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

// The longest run of parts with dots between, as in a.b.c, and the line that it is in.
struct DottedRun {
    int parts = 0;
    int line = 1;
};

DottedRun find_longest_run(std::string_view text) {
    const auto is_letter = [](char letter) {
        return std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '_' || letter == '-' ||
               letter == '"' || letter == '\'';
    };
    DottedRun longest;
    int line = 1;
    int parts = 0;
    char before = '.';  // the last letter that was not a blank
    bool is_blank_before = false;
    for (const char letter : text) {
        if (letter == ' ' || letter == '\t') {
            is_blank_before = true;
            continue;
        }
        if (letter == '\n') ++line;
        const bool goes_on = is_letter(letter) ? before == '.' || (is_letter(before) && !is_blank_before)
                                               : letter == '.' && is_letter(before);
        if (!goes_on) parts = 0;
        if (is_letter(letter) && (before == '.' || !goes_on)) ++parts;
        if (parts > longest.parts) longest = {parts, line};
        before = letter;
        is_blank_before = false;
    }
    return longest;
}

// What reads, checks and frees a deck goes as deep as its tables; toml++ bounds that of brackets, not of
// a.b.c.
void check_depth(std::string_view text, const std::string& file) {
    constexpr int most_parts = 16;
    const DottedRun longest = find_longest_run(text);
    if (longest.parts <= most_parts) return;
    const std::string message =
        fmt::format("a key of {} parts, where a.b.c has 3; {} are the most", longest.parts, most_parts);
    throw DeckError({{file, longest.line, 1, "", message}});
}

void check_letters(std::string_view text, const Place& place, const std::string& file) {
    const std::size_t at = find_control_character(text);
    if (at == std::string_view::npos) return;
    const std::string shown = printable(text.substr(at, 2)).substr(0, 4);
    throw DeckError(
        {{file,
          place.line,
          place.column,
          "",
          fmt::format("has the control character {}; expected a text that can be shown", shown)}});
}

// Whatever a text is for, in the end it is shown somewhere: by a terminal, in a page, by other programs.
void check_texts(const DeckNode& node, const std::string& file) {
    if (node.text() != nullptr) check_letters(*node.text(), node.place, file);
    if (node.array() != nullptr) {
        for (const DeckNode& element : *node.array()) check_texts(element, file);
    }
    if (node.table() == nullptr) return;
    for (const DeckEntry& entry : *node.table()) {
        check_letters(entry.key, entry.place, file);
        check_texts(entry.node, file);
    }
}

DeckNode parse_toml(std::string_view text, const std::string& file) {
    try {
        const toml::table table = toml::parse(text, std::string_view(file));
        return {convert_table(table), {}};
    } catch (const toml::parse_error& error) {
        throw DeckError({explain_syntax_fault(text, file, place_of(error.source()), error.description())});
    }
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
    check_depth(text, file);
    DeckNode tree = parse_toml(text, file);
    check_texts(tree, file);
    return tree;
}

}  // namespace gxrod
