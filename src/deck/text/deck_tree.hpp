#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "deck/text/fault_list.hpp"

// The tree of a deck's text: tables, arrays and values in the order of the text, each with its place.
namespace gxrod {

struct DeckEntry;

// A TOML date or time, which no key of a deck accepts.
struct DeckDate {
    std::string text;
};

struct DeckNode {
    using Table = std::vector<DeckEntry>;  // in deck order
    using Array = std::vector<DeckNode>;

    std::variant<Table, Array, std::string, std::int64_t, double, bool, DeckDate> value;
    Place place;

    const Table* table() const { return std::get_if<Table>(&value); }
    Table* table() { return std::get_if<Table>(&value); }
    const Array* array() const { return std::get_if<Array>(&value); }
    Array* array() { return std::get_if<Array>(&value); }
    const std::string* text() const { return std::get_if<std::string>(&value); }

    // Finds the entry of a table, or nullptr. The node must be a table.
    const DeckEntry* find(std::string_view key) const;
    DeckEntry* find(std::string_view key);
};

struct DeckEntry {
    std::string key;
    Place place;  // place of the key
    DeckNode node;
};

// Reads the tree of a TOML text. Throws DeckError with the one fault at which reading stops.
DeckNode read_toml(std::string_view text, const std::string& file);

}  // namespace gxrod
