#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "rotation/types.hpp"

// Every key of a deck, declared once: the reader checks against these declarations and takes the defaults
// from them, and the JSON Schema and docs/deck.md are written from them. Plans of batches are declared
// the same way (batch/plan/plan_schema.hpp).
namespace gxrod {

// The shape of what a deck has at a key.
enum class KeyShape {
    value,  // as the kind of its field says (deck/table/kinds.hpp); or a table in its place, if it has one
    table,
    named_tables,  // [rod.NAME], any number
    table_list,    // [[load]], any number
    parameters,    // any names, a number each
    variations     // any keys of a deck in quotes, a list of values or a table each
};

enum class Bound { closed, open };

// The range of a number, or of every component. `lower` is open at -infinity, `upper` at +infinity.
struct Range {
    double lower = -std::numeric_limits<double>::infinity();
    Bound at_lower = Bound::closed;
    double upper = std::numeric_limits<double>::infinity();
    Bound at_upper = Bound::closed;

    bool contains(double value) const;
    bool is_unbounded() const;
};

// A required key is required where it is used.
enum class Presence { optional, required };

// A condition: the key is used only where another key of its table has one of these words.
struct Condition {
    std::string key;
    std::vector<std::string> words;
};

struct Binding;
struct TableHead;
struct TableSpec;

struct KeySpec {
    std::string name;
    KeyShape shape = KeyShape::value;
    std::string dimension = {};
    Range range = {};
    Presence presence = Presence::optional;
    std::variant<std::monostate, double, long, std::string, Vec3> default_value = {};
    std::string default_text = {};  // of a default that follows from other keys
    std::string sentence = {};
    std::vector<std::string> choices = {};
    std::string remark = {};       // ends the messages that the key is missing, out of range or no valid word
    std::string above_range = {};  // ends the message that a number is above its range instead
    std::vector<Condition> only_for = {};              // all of them
    std::string only_with = {};                        // the key is used only where this one is given
    std::vector<std::string> refers_to = {};           // the tables whose names it takes
    const TableSpec* table = nullptr;                  // of what has tables
    std::shared_ptr<const Binding> binding = nullptr;  // of a key that is bound to a field of a struct
    bool may_change = false;                           // when a run is resumed
    bool takes_one = false;                            // of a list of tables: also a single one
};

enum class GroupRule { exactly_one, at_least_one, at_most_one };

// Which keys exclude each other; applies as its conditions say.
struct KeyGroup {
    GroupRule rule;
    std::vector<std::string> keys;
    std::vector<Condition> only_for = {};
    std::string only_with = {};
};

// The names that other programs give a key, or have where a table has something else.
struct OtherNames {
    std::string key;    // of the table, or "a.b" of a table in it; "" if `remark` says it all
    std::string words;  // lower case, with blanks between
    std::string remark = {};

    bool operator==(const OtherNames&) const = default;
};

struct TableSpec {
    std::string path;     // "rod.NAME", "load"; "" for the top level
    std::string heading;  // as a deck writes it: "[rod.NAME]"
    std::string sentence;
    std::vector<KeySpec> keys;
    std::vector<KeyGroup> groups = {};
    std::string example = {};  // the examples of all tables, one after the other, are a deck
    std::vector<OtherNames> other_names = {};
    // Makes the struct that the table is read into, of a table whose keys are bound to fields
    // (deck/table/table.hpp).
    std::function<std::shared_ptr<TableHead>()> make = {};

    const KeySpec* find(std::string_view key) const;
    std::vector<std::string> key_names() const;
};

// The top level of a deck.
const TableSpec& deck_schema();

// Whether the key is one of the top level `root`, before the first [table], such as gravity.
bool is_top_level_value(const TableSpec& root, std::string_view key);

// Says that such a key was found in the table of `heading`.
std::string explain_misplaced_key(std::string_view key, std::string_view heading);

// "greater than 0, at most 0.5", "at least 1", "from 0 to 1"; "" if unbounded.
std::string describe_range(const Range& range);

// The variables of expressions of this key, as messages say them: "t and s".
std::string variables_of(const KeySpec& key);

// A key as messages that list keys say it: a table by its heading.
std::string spell(const KeySpec& key);

// Describes the value that a key takes, as messages say it: "a number greater than 0 or an expression".
std::string describe_expected(const KeySpec& key);

// JSON Schema, draft 2020-12, for editors; no line end at its end.
std::string json_schema(const TableSpec& root, const std::string& title);

// The text of docs/deck.md, without its last line end.
std::string deck_reference();

// The tables of `root` as Markdown, without a last line end.
std::string table_reference(const TableSpec& root);

}  // namespace gxrod
