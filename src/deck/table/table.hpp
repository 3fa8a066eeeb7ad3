#pragma once

#include <algorithm>
#include <cassert>
#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "deck/table/kinds.hpp"

// Declares a table of the deck: a struct, and keys that are bound to its fields. From it follow how the table
// is read, what is a fault in it, docs/deck.md and the JSON Schema. The initialiser of a field is the default
// of its key.
namespace gxrod {

template <class Value>
concept IsTable = std::is_base_of_v<TableHead, Value>;

// The type that a field holds: the value itself, or one that the deck may leave out.
template <class Field>
struct FieldTraits {
    using Value = Field;
    static const void* find(const Field& field) { return &field; }
};

template <class Inner>
struct FieldTraits<std::optional<Inner>> {
    using Value = Inner;
    static constexpr KeyShape shape = KeyShape::table;
    static const void* find(const std::optional<Inner>& field) { return field ? &*field : nullptr; }
    static void hold(const Inner& table, std::optional<Inner>& field) { field = table; }
};

// A number or rows, or a table in their place.
template <class Other, IsTable Inner>
struct FieldTraits<std::optional<std::variant<Other, Inner>>> {
    using Field = std::optional<std::variant<Other, Inner>>;
    using Value = Inner;
    using Alternative = Other;
    static constexpr KeyShape shape = KeyShape::value;
    static const void* find(const Field& field) { return field ? &*field : nullptr; }
    static void hold(const Inner& table, Field& field) { field = table; }
};

template <IsTable Inner>
struct FieldTraits<std::vector<Inner>> {
    using Value = Inner;
    static constexpr KeyShape shape = KeyShape::table_list;
    static const void* find(const std::vector<Inner>& field) { return field.empty() ? nullptr : &field; }
    static void hold(const Inner& table, std::vector<Inner>& field) { field.push_back(table); }
};

// T derives from TableHead. What follows a key() is about this key.
template <class T>
class Table {
  public:
    // The heading is as a deck has it: [spring.NAME] or [[load]]; or, of a table in a table, its path, such
    // as bushing.NAME.stiffness, with [] at its end if it is one of a list; or empty, of the top level.
    Table(const std::string& heading, std::string sentence) {
        spec_.sentence = std::move(sentence);
        spec_.make = [] { return std::make_shared<T>(); };
        if (heading.empty()) return;
        const bool has_brackets = heading.starts_with('[');
        const std::size_t from = heading.find_first_not_of('[');
        spec_.path = heading.substr(from, heading.find_last_not_of("[]") + 1 - from);
        spec_.heading = has_brackets ? heading
                                     : spec_.path.substr(spec_.path.rfind('.') + 1) +
                                           (heading.ends_with("[]") ? " = [{ … }, …]" : " = { … }");
    }

    // `access` is a member pointer, or takes a T& and returns a reference to one of its fields.
    template <class Access>
    Table& key(const std::string& name, Access access, const std::string& sentence) {
        using Traits = FieldTraits<FieldOf<Access>>;
        using Stored = typename Traits::Value;
        Binding binding = bind(access);
        binding.kind = &value_kind<Stored>;
        binding.read = [access](const ValueSource& from, TableHead& table) {
            auto value = Kind<Stored>::read(from);
            if (value) field(access, table) = std::move(*value);
            return value.has_value();
        };
        binding.print = [access](const TableHead& table) {
            const void* found = Traits::find(field(access, table));
            return found == nullptr ? "" : Kind<Stored>::print(*static_cast<const Stored*>(found));
        };
        add({.name = name, .sentence = sentence}, binding);
        if constexpr (requires { Kind<Stored>::choices(); }) last().choices = Kind<Stored>::choices();
        if constexpr (std::is_same_v<Stored, FieldOf<Access>> &&
                      requires(Stored value) { Kind<Stored>::default_value(value); }) {
            T fresh;
            last().default_value = Kind<Stored>::default_value(std::invoke(access, fresh));
        }
        return *this;
    }

    // Adds a table in this table as an std::optional, in place of a number or of rows or not, or a list of
    // them as an std::vector.
    template <class Access>
    Table& key(const std::string& name, Access access, const TableSpec& inner, const std::string& sentence) {
        using Traits = FieldTraits<FieldOf<Access>>;
        using Inner = typename Traits::Value;
        Binding binding = bind(access);
        binding.hold = [access](const TableHead& one, TableHead& table) {
            Traits::hold(static_cast<const Inner&>(one), field(access, table));
        };
        if constexpr (requires { typename Traits::Alternative; }) {
            using Other = typename Traits::Alternative;
            binding.kind = &value_kind<Other>;
            binding.read = [access](const ValueSource& from, TableHead& table) {
                auto value = Kind<Other>::read(from);
                if (value) field(access, table) = std::move(*value);
                return value.has_value();
            };
            binding.print = [access](const TableHead& table) {
                const auto& given = field(access, table);
                const Other* value = given ? std::get_if<Other>(&*given) : nullptr;
                return value == nullptr ? "" : Kind<Other>::print(*value);
            };
        }
        add({.name = name, .shape = Traits::shape, .sentence = sentence, .table = &inner}, binding);
        return *this;
    }

    // The key takes a single table as well as a list.
    Table& or_one() {
        last().takes_one = true;
        return *this;
    }

    // Adds keys of another table, whose struct is a base of T: all of them, or those of these names.
    template <class Base>
        requires std::is_base_of_v<Base, T>
    Table& keys_of(const Table<Base>& base, const std::vector<std::string>& names = {}) {
        const TableSpec spec = base;
        for (const KeySpec& key : spec.keys) {
            if (names.empty() || std::ranges::find(names, key.name) != names.end()) spec_.keys.push_back(key);
        }
        return *this;
    }

    // Adds tables that are not held by this one: their own functions find them in the deck.
    Table& tables(const std::string& name, KeyShape shape, const TableSpec& inner) {
        spec_.keys.push_back({.name = name, .shape = shape, .table = &inner});
        return *this;
    }

    // Adds what a function adds.
    Table& with(void (*add_to)(Table& table)) {
        add_to(*this);
        return *this;
    }

    Table& unit(const std::string& dimension) {
        last().dimension = dimension;
        return *this;
    }
    Table& at_least(double bound) {
        last().range.lower = bound;
        return *this;
    }
    Table& at_most(double bound) {
        last().range.upper = bound;
        return *this;
    }
    Table& above(double bound) {
        last().range.lower = bound;
        last().range.at_lower = Bound::open;
        return *this;
    }
    Table& between(double lower, double upper) {
        last().range = {.lower = lower, .upper = upper};
        return *this;
    }
    Table& required() {
        last().presence = Presence::required;
        last().default_value = {};
        return *this;
    }
    // Describes the value of a key that is not given.
    Table& otherwise(const std::string& text) {
        last().default_text = text;
        last().default_value = {};
        return *this;
    }
    // Names the key as other programs do: words, in lower case; a remark if it is not quite the same.
    Table& also(const char* words, const char* remark = "") {
        spec_.other_names.push_back({last().name, words, remark});
        return *this;
    }
    // Names what other programs have in such a table and this one in a table in it, as in "wind.velocity".
    Table& has_as(const char* key, const char* words) {
        spec_.other_names.push_back({key, words});
        return *this;
    }
    // The words that the key takes.
    Table& words(const std::vector<std::string>& choices) {
        last().choices = choices;
        return *this;
    }
    // The kinds of tables whose names the key takes.
    Table& names_of(const std::vector<std::string>& kinds) {
        last().refers_to = kinds;
        return *this;
    }
    // The key goes with another one, and is of no use without it.
    Table& only_with(const std::string& key) {
        last().only_with = key;
        return *this;
    }
    // The key is of use only where other keys have these words.
    Table& only_for(const std::vector<Condition>& conditions) {
        last().only_for = conditions;
        return *this;
    }
    // The key may have another value when a run is resumed.
    Table& may_change() {
        last().may_change = true;
        return *this;
    }
    // Ends messages that the key is missing or out of range.
    Table& remark(const std::string& text) {
        last().remark = text;
        return *this;
    }

    // Ends the message that the key is above its range.
    Table& above_range(const std::string& text) {
        last().above_range = text;
        return *this;
    }

    // Applies with the key `with`, if there is one.
    Table& exactly_one_of(std::vector<std::string> keys,
                          std::vector<Condition> only_for = {},
                          std::string with = "") {
        return group(GroupRule::exactly_one, std::move(keys), std::move(with), std::move(only_for));
    }
    Table& at_least_one_of(std::vector<std::string> keys, std::string with = "") {
        return group(GroupRule::at_least_one, std::move(keys), std::move(with));
    }
    Table& at_most_one_of(std::vector<std::string> keys, std::vector<Condition> only_for = {}) {
        return group(GroupRule::at_most_one, std::move(keys), "", std::move(only_for));
    }
    // Names what other programs have in such a table and this one has elsewhere, or not: the remark says what
    // to do.
    Table& not_here(const char* words, const char* remark) {
        spec_.other_names.push_back({"", words, remark});
        return *this;
    }
    // An example in docs/deck.md. All of them together are a deck.
    Table& shown_by(std::string example) {
        spec_.example = std::move(example);
        return *this;
    }

    operator TableSpec() const { return spec_; }

  private:
    template <class Access>
    using FieldOf = std::remove_cvref_t<std::invoke_result_t<Access, T&>>;

    template <class Access>
    static FieldOf<Access>& field(const Access& access, TableHead& table) {
        return std::invoke(access, static_cast<T&>(table));
    }
    template <class Access>
    static const FieldOf<Access>& field(const Access& access, const TableHead& table) {
        return std::invoke(access, static_cast<const T&>(table));
    }

    template <class Access>
    static Binding bind(const Access& access) {
        Binding binding;
        binding.field = [access](const TableHead& table) -> const void* { return &field(access, table); };
        binding.value = [access](const TableHead& table) {
            return FieldTraits<FieldOf<Access>>::find(field(access, table));
        };
        return binding;
    }

    void add(KeySpec key, const Binding& binding) {
        key.binding = std::make_shared<const Binding>(binding);
        spec_.keys.push_back(std::move(key));
    }
    KeySpec& last() { return spec_.keys.back(); }
    Table& group(GroupRule rule,
                 std::vector<std::string> keys,
                 std::string with = "",
                 std::vector<Condition> only_for = {}) {
        spec_.groups.push_back({rule, std::move(keys), std::move(only_for), std::move(with)});
        return *this;
    }

    TableSpec spec_;
};

// The tables of a deck that `spec` declares, in deck order; T is their struct, or a base of it.
template <class T>
std::vector<std::reference_wrapper<const T>> tables_of(const CheckedTable& deck, const TableSpec& spec) {
    std::vector<std::reference_wrapper<const T>> tables;
    for (const CheckedTable& one : deck.tables(spec.path.substr(0, spec.path.find('.'))))
        tables.push_back(static_cast<const T&>(*one.record));
    return tables;
}

// The values that a table has, of all keys of one kind, in the order of the keys.
template <class Value>
std::vector<std::reference_wrapper<const Value>> values_of(const TableHead& table) {
    std::vector<std::reference_wrapper<const Value>> values;
    for (const KeySpec& key : table.spec->keys) {
        const void* value = key.binding->kind == &value_kind<Value> ? key.binding->value(table) : nullptr;
        if (value != nullptr) values.push_back(*static_cast<const Value*>(value));
    }
    return values;
}

}  // namespace gxrod
