#include "deck/text/toml_writing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

namespace gxrod {
namespace {

std::string write_quoted(std::string_view text) {
    std::string quoted = "\"";
    for (const char letter : text) {
        const auto code = static_cast<unsigned char>(letter);
        if (letter == '"' || letter == '\\') {
            quoted += {'\\', letter};
        } else if (code < 0x20 || code == 0x7F) {
            quoted += fmt::format("\\u{:04X}", static_cast<unsigned>(code));
        } else {
            quoted += letter;
        }
    }
    return quoted + '"';
}

// The shortest decimal that reads back to the same double.
std::string write_number(double number) {
    std::array<char, 32> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number).ptr;
    std::string text(buffer.data(), end);
    if (text.find_first_of(".en") == std::string::npos) text += ".0";
    return text;
}

std::string write_value(const DeckNode& node);

template <class Sequence, class Write>
std::string write_sequence(const Sequence& sequence, Write write) {
    std::string text;
    for (const auto& member : sequence) {
        if (!text.empty()) text += ", ";
        text += write(member);
    }
    return text;
}

std::string write_entry(const DeckEntry& entry) {
    return fmt::format("{} = {}", write_toml_key(entry.key), write_value(entry.node));
}

struct ValueWriter {
    std::string operator()(const DeckNode::Table& table) const {
        return table.empty() ? "{}" : fmt::format("{{ {} }}", write_sequence(table, write_entry));
    }
    std::string operator()(const DeckNode::Array& array) const {
        return fmt::format("[{}]", write_sequence(array, write_value));
    }
    std::string operator()(const std::string& text) const { return write_quoted(text); }
    std::string operator()(std::int64_t number) const { return std::to_string(number); }
    std::string operator()(double number) const { return write_number(number); }
    std::string operator()(bool truth) const { return truth ? "true" : "false"; }
    std::string operator()(const DeckDate& date) const { return date.text; }
};

std::string write_value(const DeckNode& node) { return std::visit(ValueWriter{}, node.value); }

bool is_table(const DeckNode& node) { return node.table() != nullptr; }

bool is_table_list(const DeckNode& node) {
    const DeckNode::Array* array = node.array();
    return array != nullptr && !array->empty() && std::all_of(array->begin(), array->end(), is_table);
}

std::string write_body(const DeckNode::Table& table) {
    std::string text;
    for (const DeckEntry& entry : table) text += write_entry(entry) + "\n";
    return text;
}

// A table of named tables, such as the rods, has no header of its own.
bool holds_tables_only(const DeckNode::Table& table) {
    return !table.empty() && std::all_of(table.begin(), table.end(), [](const DeckEntry& entry) {
        return is_table(entry.node);
    });
}

std::string write_tables(const DeckEntry& entry) {
    const std::string name = write_toml_key(entry.key);
    std::string text;
    if (is_table_list(entry.node)) {
        for (const DeckNode& element : *entry.node.array()) {
            text += fmt::format("\n[[{}]]\n{}", name, write_body(*element.table()));
        }
    } else if (holds_tables_only(*entry.node.table())) {
        for (const DeckEntry& inner : *entry.node.table()) {
            text += fmt::format(
                "\n[{}.{}]\n{}", name, write_toml_key(inner.key), write_body(*inner.node.table()));
        }
    } else {
        text += fmt::format("\n[{}]\n{}", name, write_body(*entry.node.table()));
    }
    return text;
}

}  // namespace

std::string write_toml(const DeckNode& deck) {
    std::string values;
    std::string tables;
    for (const DeckEntry& entry : *deck.table()) {
        if (is_table(entry.node) || is_table_list(entry.node)) {
            tables += write_tables(entry);
        } else {
            values += write_entry(entry) + "\n";
        }
    }
    return values + tables;
}

std::string write_toml_key(const std::string& key) {
    const auto is_bare = [](char letter) {
        return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
               (letter >= '0' && letter <= '9') || letter == '_' || letter == '-';
    };
    return !key.empty() && std::all_of(key.begin(), key.end(), is_bare) ? key : write_quoted(key);
}

std::string write_toml_value(const DeckNode& node) { return write_value(node); }

}  // namespace gxrod
