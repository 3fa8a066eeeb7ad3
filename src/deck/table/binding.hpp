#pragma once

#include <functional>
#include <string>

#include "deck/reading/reading_context.hpp"
#include "deck/schema/schema.hpp"
#include "deck/table/table_head.hpp"

// How a key of a table is bound to a field of the struct that the table is read into. Nothing here is a
// template, so that whoever walks the schema sees all keys alike.
namespace gxrod {

// A value of a deck, and the key that it is for.
struct ValueSource {
    const DeckNode& node;
    const std::string& path;
    const KeySpec& key;
    const ReadingContext& context;
};

// The nature of a value, for code that does not know its type.
enum class ValueNature { other, number, integer, word };

// How the values of a C++ type are described: a Kind<T> without its type.
struct ValueKind {
    ValueNature nature = ValueNature::other;
    std::string (*words)(const KeySpec& key) = nullptr;   // in messages, after "expected"
    std::string (*column)(const KeySpec& key) = nullptr;  // in docs/deck.md
    std::string (*schema)(const KeySpec& key) = nullptr;  // in the JSON Schema, as JSON
    std::string (*sample)(const KeySpec& key) = nullptr;  // a value for tests, as `print` writes it
    std::string (*variables)() = nullptr;                 // of expressions, in messages
};

struct Binding {
    const ValueKind* kind = nullptr;  // nullptr of a table in a table, or in place of a number
    // The address of the field, by which faults find their key.
    std::function<const void*(const TableHead& table)> field;
    // The address of the value in the field; nullptr if the field is an std::optional without one
    // or an empty list of tables.
    std::function<const void*(const TableHead& table)> value;
    // Sets the field. Whether the value is right; what is wrong with it is a fault then.
    std::function<bool(const ValueSource& from, TableHead& table)> read = {};
    // Takes a table that stands in this one.
    std::function<void(const TableHead& inner, TableHead& table)> hold = {};
    // The value as a deck has it; "" if there is none.
    std::function<std::string(const TableHead& table)> print = {};
};

// The kind of a key's values; nullptr of a key that has tables alone.
inline const ValueKind* find_kind(const KeySpec& key) { return key.binding ? key.binding->kind : nullptr; }

inline ValueNature nature_of(const KeySpec& key) {
    const ValueKind* kind = find_kind(key);
    return kind == nullptr ? ValueNature::other : kind->nature;
}

}  // namespace gxrod
