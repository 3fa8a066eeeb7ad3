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

// How the values of a C++ type are described: a Kind<T> without its type.
struct ValueKind {
    // Which of the types that the schema's switches describe; `bound` for one that the functions here
    // describe.
    ValueType type = ValueType::bound;
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

// The kind of a key that describes itself; nullptr if the schema's switches do.
inline const ValueKind* find_kind(const KeySpec& key) {
    const ValueKind* kind = key.binding ? key.binding->kind : nullptr;
    return kind != nullptr && kind->type == ValueType::bound ? kind : nullptr;
}

}  // namespace gxrod
