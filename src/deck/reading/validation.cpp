#include "deck/reading/validation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "deck/expressions/expression_syntax.hpp"
#include "deck/expressions/symbol_reading.hpp"
#include "deck/schema/choices.hpp"
#include "deck/schema/schema_tables.hpp"
#include "deck/schema/suggestion.hpp"
#include "deck/schema/synonyms.hpp"
#include "deck/table/binding.hpp"
#include "deck/ties/ties.hpp"
#include "model/joint.hpp"
#include "watch/quantities.hpp"

namespace gxrod {
namespace {

bool is_plain_name(const std::string& name) {
    return !name.empty() && std::all_of(name.begin(), name.end(), [](char letter) {
        return letter == '_' || letter == '-' || std::isalnum(static_cast<unsigned char>(letter)) != 0;
    });
}

std::string join_path(const std::string& path, const std::string& key) {
    return path.empty() ? key : path + "." + key;
}

// Keys of single tables such as [analysis], which a user may look for at the top level.
std::string find_key_elsewhere(const TableSpec& root, const std::string& key) {
    for (const KeySpec& entry : root.keys) {
        if (entry.shape != KeyShape::table) continue;
        if (entry.table->find(key) != nullptr) return entry.name + "." + key;
        const std::optional<OtherNames> synonyms = find_synonym(*entry.table, key);
        if (synonyms && !synonyms->key.empty()) return entry.name + "." + synonyms->key;
    }
    return "";
}

// The paths of all tables below `root` that have this key.
void find_tables_with(const TableSpec& root, const std::string& key, std::vector<std::string>& paths) {
    for (const KeySpec& entry : root.keys) {
        if (entry.table == nullptr) continue;
        const bool is_new = std::find(paths.begin(), paths.end(), entry.table->path) == paths.end();
        if (is_new && entry.table->find(key) != nullptr) paths.push_back(entry.table->path);
        find_tables_with(*entry.table, key, paths);
    }
}

// Where a key that this table does not have can have been meant to be; "" if no or many tables have it.
std::string explain_other_tables(const TableSpec& root, const TableSpec& spec, const std::string& key) {
    std::vector<std::string> paths;
    find_tables_with(spec, key, paths);
    if (paths.empty()) find_tables_with(root, key, paths);
    if (paths.empty() || paths.size() > 2) return "";
    return fmt::format(
        "; {} {} a key of this name", fmt::join(paths, " and "), paths.size() == 1 ? "has" : "have");
}

class Validator {
  public:
    // `deck` is the whole of it; nullptr where only a table is checked.
    Validator(const TableSpec& root, const DeckNode* deck, const Symbols& symbols, FaultList& faults)
        : root_(root), deck_(deck), context_{symbols, faults} {}

    CheckedTable check_table(const DeckNode& node, const std::string& path, const TableSpec& spec) const {
        CheckedTable checked{"", path, node.place, {}};
        if (spec.make) {
            checked.record = spec.make();
            *checked.record = {&spec, "", path, node.place, {}};
        }
        for (const DeckEntry& entry : *node.table()) {
            const KeySpec* key = spec.find(entry.key);
            if (key == nullptr) {
                add_unknown_key(entry, path, spec);
                continue;
            }
            CheckedValue value{entry.key, entry.node.place, true, {}};
            const std::string full = join_path(path, entry.key);
            if (key->binding) {
                ReadingContext context = context_;
                if (deck_ != nullptr && spec.path == "history" && key->name == "quantities")
                    context.likely_words = list_likely_quantities(node);
                value.value = read_field(entry, full, *key, *checked.record, context);
            } else {
                value.value = check_tables(entry, full, *key);
            }
            checked.values.push_back(std::move(value));
        }
        add_defaults(checked, spec);
        check_presence(node, checked, spec);
        check_groups(node, checked, spec);
        check_conditions(node, checked, spec);
        check_companions(node, path, spec);
        return checked;
    }

  private:
    using Value = decltype(CheckedValue::value);

    // What a joint of its kind does not have.
    static void leave_out_coordinates(const DeckNode& joint, std::vector<std::string>& words) {
        const DeckEntry* type = joint.table() == nullptr ? nullptr : joint.find("type");
        if (type == nullptr || type->node.text() == nullptr) return;
        const std::vector<std::string> known = words_of(joint_kind_choices);
        if (std::ranges::find(known, *type->node.text()) == known.end()) return;
        Joint one;
        one.kind = value_of(joint_kind_choices, *type->node.text());
        std::erase_if(words, [&](const std::string& word) {
            return (word.starts_with("angle") && !one.has_turn()) ||
                   (word.starts_with("slide") && !one.has_slide());
        });
    }

    // What the thing that `at` of a history names can have; empty if it is not known.
    std::vector<std::string> list_likely_quantities(const DeckNode& history) const {
        const DeckEntry* at = history.find("at");
        if (at == nullptr || at->node.text() == nullptr) return {};
        const std::string& text = *at->node.text();
        const auto names = [&](std::string_view kind, std::string_view name) {
            const DeckEntry* tables = deck_->find(kind);
            return tables != nullptr && tables->node.table() != nullptr && tables->node.find(name) != nullptr;
        };
        std::vector<std::string> kinds = list_tie_words();
        kinds.insert(kinds.end(), {"tendon", "chamber", "obstacle", "body"});
        for (const std::string& kind : kinds) {
            if (!names(kind, text)) continue;
            std::vector<std::string> words = list_quantity_words(kind == "chamber" ? "tendon" : kind);
            if (kind == "joint") leave_out_coordinates(deck_->find(kind)->node.find(text)->node, words);
            return words;
        }
        if (names("rod", text) && deck_->find("contact") != nullptr) return list_quantity_words("contact");
        return names("rod", text.substr(0, text.find_first_of(".@"))) ? list_quantity_words("rod")
                                                                      : std::vector<std::string>{};
    }

    void add(const Place& place, const std::string& path, const std::string& message) const {
        context_.faults.add(place, path, message);
    }

    // Sets the field of a key. Returns words and tables, on which other keys of the table may depend.
    Value read_field(const DeckEntry& entry,
                     const std::string& path,
                     const KeySpec& key,
                     TableHead& record,
                     const ReadingContext& context) const {
        record.given.emplace_back(key.name, entry.node.place);
        if (key.table != nullptr && (entry.node.table() != nullptr || !key.binding->read)) {
            Value value = check_tables(entry, path, key);
            if (const auto* tables = std::get_if<std::vector<CheckedTable>>(&value)) {
                for (const CheckedTable& one : *tables) key.binding->hold(*one.record, record);
            }
            return value;
        }
        const bool is_right = key.binding->read({entry.node, path, key, context}, record);
        if (is_right && nature_of(key) == ValueNature::word) return *entry.node.text();
        return std::monostate{};
    }

    Value check_tables(const DeckEntry& entry, const std::string& path, const KeySpec& key) const {
        switch (key.shape) {
            case KeyShape::value:
            case KeyShape::table:
                return check_single_table(entry, path, key);
            case KeyShape::named_tables:
                return check_named_tables(entry, path, key);
            case KeyShape::table_list:
                return check_table_list(entry, path, key);
            case KeyShape::parameters:
            case KeyShape::variations:
                if (entry.node.table() == nullptr) expect(entry, path, key);
        }
        return std::monostate{};
    }

    void expect(const DeckEntry& entry, const std::string& path, const KeySpec& key) const {
        add(entry.node.place,
            path,
            fmt::format("expected {}, found {}", describe_expected(key), describe_found(entry.node)));
    }

    Value check_single_table(const DeckEntry& entry, const std::string& path, const KeySpec& key) const {
        if (entry.node.table() == nullptr) {
            expect(entry, path, key);
            return std::monostate{};
        }
        return std::vector{check_table(entry.node, path, *key.table)};
    }

    // Of tables in a table a text is short for the one key that they must have: core = "foam".
    static DeckNode write_out(const DeckNode& node, const KeySpec& key) {
        if (!key.binding || node.text() == nullptr) return node;
        std::string only;
        for (const KeySpec& one : key.table->keys) {
            if (one.presence == Presence::required) only = only.empty() ? one.name : "?";
        }
        if (key.table->find(only) == nullptr) return node;
        return {DeckNode::Table{{only, node.place, node}}, node.place};
    }

    Value check_named_tables(const DeckEntry& entry, const std::string& path, const KeySpec& key) const {
        if (entry.node.table() == nullptr) {
            expect(entry, path, key);
            return std::monostate{};
        }
        std::vector<CheckedTable> tables;
        for (const DeckEntry& named : *entry.node.table()) {
            const std::string named_path = join_path(path, named.key);
            const DeckNode node = write_out(named.node, key);
            if (node.table() == nullptr) {
                expect(named, named_path, key);
                continue;
            }
            const std::string reason = explain_name(named.key, key);
            if (!reason.empty()) add(named.place, named_path, reason);
            tables.push_back(check_table(node, named_path, *key.table));
            tables.back().name = named.key;
            if (tables.back().record) tables.back().record->name = named.key;
        }
        return tables;
    }

    static std::string explain_name(const std::string& name, const KeySpec& key) {
        if (key.binding) return "";  // names of a file
        if (is_for_expressions(key)) return explain_unusable_name(name);
        return is_plain_name(name) ? "" : "a name has letters, digits, _ and - only";
    }

    Value check_table_list(const DeckEntry& entry, const std::string& path, const KeySpec& key) const {
        const DeckNode::Array* array = entry.node.array();
        if (key.takes_one && entry.node.table() != nullptr) return check_single_table(entry, path, key);
        if (array == nullptr || (key.takes_one && array->empty())) {
            expect(entry, path, key);
            return std::monostate{};
        }
        std::vector<CheckedTable> tables;
        for (std::size_t i = 0; i < array->size(); ++i) {
            const DeckNode& element = (*array)[i];
            const std::string element_path = fmt::format("{}[{}]", path, i);
            if (element.table() == nullptr) {
                expect({entry.key, entry.place, element}, element_path, key);
                continue;
            }
            tables.push_back(check_table(element, element_path, *key.table));
        }
        return tables;
    }

    void add_unknown_key(const DeckEntry& entry, const std::string& path, const TableSpec& spec) const {
        const std::string full = join_path(path, entry.key);
        if (!path.empty() && is_top_level_value(root_, entry.key)) {
            return add(entry.place, full, explain_misplaced_key(entry.key, spec.heading));
        }
        const std::vector<std::string> known = spec.key_names();
        std::string hint = explain_synonym(spec, entry.key);
        const std::string elsewhere =
            path.empty() && hint.empty() ? find_key_elsewhere(root_, entry.key) : "";
        if (!elsewhere.empty()) {
            return add(entry.place, full, fmt::format("unknown key; did you mean \"{}\"?", elsewhere));
        }
        if (hint.empty()) hint = did_you_mean(entry.key, known);
        if (hint.empty()) {
            hint = explain_other_tables(root_, spec, entry.key) + "; known here: " + plain_list(known);
        }
        add(entry.place, full, "unknown key" + hint);
    }

    // The word of the key that a condition is about; nullptr if it is missing or wrong.
    static const std::string* word_of(const Condition& condition, const CheckedTable& checked) {
        const CheckedValue* value = checked.find(condition.key);
        return value == nullptr ? nullptr : std::get_if<std::string>(&value->value);
    }

    static bool allows(const Condition& condition, const std::string& word) {
        return std::find(condition.words.begin(), condition.words.end(), word) != condition.words.end();
    }

    // Whether the table surely uses a key or group with these conditions.
    template <class Spec>
    static bool is_used(const Spec& spec, const CheckedTable& checked) {
        if (!spec.only_with.empty() && checked.find(spec.only_with) == nullptr) return false;
        return std::all_of(spec.only_for.begin(), spec.only_for.end(), [&](const Condition& condition) {
            const std::string* word = word_of(condition, checked);
            return word != nullptr && allows(condition, *word);
        });
    }

    void check_presence(const DeckNode& node, const CheckedTable& checked, const TableSpec& spec) const {
        for (const KeySpec& key : spec.keys) {
            if (key.presence == Presence::optional || node.find(key.name) != nullptr) continue;
            if (!is_used(key, checked) || has_misspelling(node, key.name, spec)) continue;
            const std::string remark = key.remark.empty() ? "" : "; " + key.remark;
            add(node.place,
                join_path(checked.path, key.name),
                "missing; expected " + describe_expected(key) + remark);
        }
    }

    // Whether an unknown key, reported as such, was to be this one. What other programs call otherwise may
    // have been to be any key.
    static bool has_misspelling(const DeckNode& node, const std::string& key, const TableSpec& spec) {
        return std::any_of(node.table()->begin(), node.table()->end(), [&](const DeckEntry& entry) {
            if (spec.find(entry.key) != nullptr) return false;
            const std::optional<OtherNames> synonym = find_synonym(spec, entry.key);
            if (!synonym) return nearest_spelling(entry.key, spec.key_names()) == key;
            return synonym->key.empty() || synonym->key == key;
        });
    }

    void check_groups(const DeckNode& node, const CheckedTable& checked, const TableSpec& spec) const {
        const std::string& path = checked.path;
        for (const KeyGroup& group : spec.groups) {
            if (!is_used(group, checked)) continue;
            std::vector<std::string> given;
            for (const std::string& key : group.keys) {
                const DeckEntry* entry = node.find(key);
                const bool is_empty =
                    entry != nullptr && entry->node.table() != nullptr && entry->node.table()->empty();
                if (entry != nullptr && !is_empty) given.push_back(key);
            }
            const auto is_meant = [&](const std::string& key) { return has_misspelling(node, key, spec); };
            if (given.empty() && group.rule != GroupRule::at_most_one &&
                std::ranges::none_of(group.keys, is_meant)) {
                std::vector<std::string> spellings;
                for (const std::string& key : group.keys) spellings.push_back(spell(*spec.find(key)));
                add(node.place, path, fmt::format("missing; expected {}", fmt::join(spellings, " or ")));
            }
            if (given.size() > 1 && group.rule != GroupRule::at_least_one) {
                add(node.find(given[1])->place,
                    join_path(path, given[1]),
                    fmt::format("{} is given too; only one of them can be", given[0]));
            }
        }
    }

    static void add_defaults(CheckedTable& checked, const TableSpec& spec) {
        for (const KeySpec& key : spec.keys) {
            if (checked.find(key.name) != nullptr) continue;
            if (std::holds_alternative<std::monostate>(key.default_value)) continue;
            const auto* word = std::get_if<std::string>(&key.default_value);
            const Value value = word == nullptr ? Value() : Value(*word);
            checked.values.push_back({key.name, checked.place, false, value});
        }
    }

    // Of a key that the top level has as well, and was perhaps meant there.
    std::string explain_top_level(const std::string& path, const std::string& key) const {
        if (path.empty() || !is_top_level_value(root_, key)) return "";
        return "; as a key of the top level it must come before the first [table]";
    }

    void check_conditions(const DeckNode& node, const CheckedTable& checked, const TableSpec& spec) const {
        for (const KeySpec& key : spec.keys) {
            if (node.find(key.name) == nullptr) continue;
            for (const Condition& condition : key.only_for) {
                const std::string* word = word_of(condition, checked);
                if (word == nullptr || allows(condition, *word)) continue;
                // A default of a key that the table does not use says nothing.
                const bool is_given = node.find(condition.key) != nullptr;
                if (!is_given && !is_used(*spec.find(condition.key), checked)) continue;
                add(node.find(key.name)->place,
                    join_path(checked.path, key.name),
                    fmt::format("{} \"{}\" does not use this key; it is for {}{}",
                                condition.key,
                                *word,
                                plain_list(condition.words),
                                explain_top_level(checked.path, key.name)));
                break;
            }
        }
    }

    // Keys that go with another one, where the table has what excludes that one.
    void check_companions(const DeckNode& node, const std::string& path, const TableSpec& spec) const {
        for (const KeySpec& key : spec.keys) {
            const DeckEntry* entry = node.find(key.name);
            if (entry == nullptr || key.only_with.empty() || node.find(key.only_with) != nullptr) continue;
            const std::string rival = find_rival(node, key.only_with, spec);
            if (rival.empty()) continue;
            std::vector<std::string> companions;
            for (const KeySpec& other : spec.keys) {
                if (other.only_with == rival) companions.push_back(other.name);
            }
            add(entry->place,
                join_path(path, key.name),
                fmt::format("goes with {}, and this table has {}{}",
                            key.only_with,
                            rival,
                            companions.empty() ? "" : ", with which go " + plain_list(companions)));
        }
    }

    // The key of the table that excludes this one; "" if there is none.
    static std::string find_rival(const DeckNode& node, const std::string& key, const TableSpec& spec) {
        for (const KeyGroup& group : spec.groups) {
            if (std::find(group.keys.begin(), group.keys.end(), key) == group.keys.end()) continue;
            for (const std::string& rival : group.keys) {
                if (node.find(rival) != nullptr) return rival;
            }
        }
        return "";
    }

    const TableSpec& root_;
    const DeckNode* deck_;
    ReadingContext context_;
};

}  // namespace

CheckedTable check_deck(const DeckNode& deck, FaultList& faults) {
    const Symbols symbols = read_symbols(deck, faults);
    CheckedTable checked =
        Validator(deck_schema(), &deck, symbols, faults).check_table(deck, "", deck_schema());
    checked.inputs.insert(symbols.inputs.begin(), symbols.inputs.end());
    return checked;
}

CheckedTable check_text(const DeckNode& text, const TableSpec& root, FaultList& faults) {
    return Validator(root, nullptr, {}, faults).check_table(text, "", root);
}

CheckedTable check_table(const DeckNode& node,
                         const std::string& path,
                         const TableSpec& table,
                         FaultList& faults) {
    return Validator(table, nullptr, {}, faults).check_table(node, path, table);
}

}  // namespace gxrod
