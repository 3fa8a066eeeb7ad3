#include "deck/text/overrides.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "deck/schema/schema.hpp"
#include "deck/schema/suggestion.hpp"
#include "deck/text/override_key.hpp"
#include "deck/text/toml_writing.hpp"

namespace gxrod {
namespace {

// A fault of one override, for apply_overrides to report.
struct OverrideFault {
    std::string key;
    std::string message;
};

void set_place(DeckNode& node, const Place& place) {
    node.place = place;
    if (DeckNode::Table* table = node.table()) {
        for (DeckEntry& entry : *table) {
            entry.place = place;
            set_place(entry.node, place);
        }
    }
    if (DeckNode::Array* array = node.array()) {
        for (DeckNode& element : *array) set_place(element, place);
    }
}

bool is_text_of_a_deck(const std::string& text) {
    try {
        read_toml(write_toml({DeckNode::Table{{"v", {}, {text, {}}}}, {}}), "");
        return true;
    } catch (const DeckError&) {
        return false;
    }
}

// The value as TOML, or as text where it is not; what begins like an array, a table or quoted text must be
// TOML.
DeckNode read_override_value(const std::string& key, const std::string& text, const Place& place) {
    DeckNode value{text, {}};
    try {
        DeckNode deck = read_toml("v = " + text, "");
        if (deck.table()->size() == 1) value = std::move(deck.table()->front().node);
    } catch (const DeckError& error) {
        if (!text.empty() && std::string_view("[{\"'").find(text[0]) != std::string_view::npos) {
            throw OverrideFault{key, error.faults[0].message};
        }
    }
    if (value.text() != nullptr && !is_text_of_a_deck(*value.text()))
        throw OverrideFault{key, "not UTF-8 text"};
    set_place(value, place);
    return value;
}

// Goes from the top of a deck to the place that a key names.
class Walk {
  public:
    Walk(DeckNode& deck, const std::vector<KeyStep>& steps, const Place& place)
        : steps_(steps), place_(place), node_(&deck), table_(&deck_schema()) {}

    void set(DeckNode value) {
        for (at_ = 0; at_ + 1 < steps_.size(); ++at_) enter();
        if (const auto* name = std::get_if<std::string>(&steps_[at_])) {
            DeckNode::Table& table = need_table();
            remove_alternatives(table, *name);
            if (DeckEntry* entry = node_->find(*name)) {
                *entry = {*name, place_, std::move(value)};
            } else {
                table.push_back({*name, place_, std::move(value)});
            }
        } else {
            need_element() = std::move(value);
        }
    }

  private:
    std::string path() const { return join_key(steps_, at_); }

    DeckNode::Table& need_table() {
        if (DeckNode::Table* table = node_->table()) return *table;
        const std::string& name = std::get<std::string>(steps_[at_]);
        const std::string hint = node_->array() == nullptr
                                     ? ""
                                     : fmt::format("; write {}[0].{} for the first of a list", path(), name);
        throw OverrideFault{path(), fmt::format("not a table, so that it has no key {}{}", name, hint)};
    }

    DeckNode& need_element() {
        DeckNode::Array* array = node_->array();
        if (array == nullptr) throw OverrideFault{path(), "not an array, so that it has no elements"};
        const std::size_t index = std::get<std::size_t>(steps_[at_]);
        if (index < array->size()) return (*array)[index];
        const std::string valid =
            array->empty() ? "it is empty" : fmt::format("valid are 0 to {}", array->size() - 1);
        throw OverrideFault{join_key(steps_, at_ + 1), "no such element; " + valid};
    }

    void enter() {
        if (std::holds_alternative<std::size_t>(steps_[at_])) {
            node_ = &need_element();
            table_ = std::exchange(named_, nullptr);
            return;
        }
        const std::string& name = std::get<std::string>(steps_[at_]);
        DeckNode::Table& table = need_table();
        if (node_->find(name) == nullptr) {
            if (!deck_has_once(name))
                throw OverrideFault{join_key(steps_, at_ + 1), explain_missing(table, name)};
            table.push_back({name, place_, {DeckNode::Table{}, place_}});
        }
        descend_schema(name);
        node_ = &node_->find(name)->node;
    }

    // Whether the schema has exactly one such table here, which can be added.
    bool deck_has_once(const std::string& name) const {
        const KeySpec* key = table_ == nullptr ? nullptr : table_->find(name);
        return key != nullptr &&
               (key->shape == KeyShape::table || key->shape == KeyShape::parameters || key->takes_one);
    }

    std::string explain_missing(const DeckNode::Table& table, const std::string& name) const {
        if (table_ != nullptr && table_->find(name) != nullptr) return "the deck has none";
        std::vector<std::string> known;
        for (const DeckEntry& entry : table) known.push_back(entry.key);
        const std::string hint = did_you_mean(name, known);
        return "the deck has none" + (hint.empty() ? "; known here: " + plain_list(known) : hint);
    }

    // Takes out the keys of the deck's text that exclude the new one, as steps excludes time_step.
    void remove_alternatives(DeckNode::Table& table, const std::string& name) const {
        if (table_ == nullptr) return;
        for (const KeyGroup& group : table_->groups) {
            const auto has = [&](const std::string& key) {
                return std::find(group.keys.begin(), group.keys.end(), key) != group.keys.end();
            };
            if (group.rule == GroupRule::at_least_one || !has(name)) continue;
            std::erase_if(table, [&](const DeckEntry& entry) {
                return entry.key != name && has(entry.key) && entry.place.override_index < 0;
            });
        }
    }

    void descend_schema(const std::string& name) {
        if (named_ != nullptr) {
            table_ = std::exchange(named_, nullptr);
            return;
        }
        const KeySpec* key = table_ == nullptr ? nullptr : table_->find(name);
        const TableSpec* found = key == nullptr ? nullptr : key->table;
        const bool is_one = key != nullptr && key->takes_one && node_->find(name)->node.table() != nullptr;
        const bool is_group = found != nullptr && key->shape != KeyShape::table && !is_one;
        table_ = is_group ? nullptr : found;
        named_ = is_group ? found : nullptr;
    }

    const std::vector<KeyStep>& steps_;
    Place place_;
    DeckNode* node_;
    const TableSpec* table_;            // of the current table, if the schema has one
    const TableSpec* named_ = nullptr;  // of the tables that the current table or list holds
    std::size_t at_ = 0;
};

void apply_override(const std::string& text, const Place& place, DeckNode& deck) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos) throw OverrideFault{"", "expected KEY=VALUE"};
    const std::string key = text.substr(0, equals);
    const auto steps = split_key(key);
    if (!steps) throw OverrideFault{key, "not a key; expected one such as analysis.beta or load[0].force"};
    Walk(deck, *steps, place).set(read_override_value(key, text.substr(equals + 1), place));
}

}  // namespace

void apply_overrides(const std::vector<std::string>& overrides, DeckNode& deck, FaultList& faults) {
    for (std::size_t i = 0; i < overrides.size(); ++i) {
        const Place place{static_cast<int>(i), 0, 0};
        try {
            apply_override(overrides[i], place, deck);
        } catch (const OverrideFault& fault) {
            faults.add(place, fault.key, fault.message);
        }
    }
}

std::string describe_missing_parameter(const std::string& key, const DeckNode& deck) {
    const auto steps = split_key(key);
    if (!steps || steps->size() != 2 || steps->at(0) != KeyStep("parameters")) return "";
    std::vector<std::string> names;
    const DeckEntry* table = deck.find("parameters");
    if (table != nullptr && table->node.table() != nullptr) {
        for (const DeckEntry& entry : *table->node.table()) names.push_back(entry.key);
    }
    const auto* name = std::get_if<std::string>(&steps->at(1));
    if (name == nullptr || std::find(names.begin(), names.end(), *name) != names.end()) return "";
    const std::string hint = did_you_mean(*name, names);
    const std::string known = names.empty() ? "; it has none" : "; it has " + plain_list(names);
    return fmt::format("parameter \"{}\"{}", *name, hint.empty() ? known : hint);
}

std::string write_overridden_deck(const std::string& name,
                                  const std::vector<std::string>& overrides,
                                  const DeckNode& deck) {
    std::string comment = "# " + name + ", run with";
    for (const std::string& text : overrides) comment += " --set " + text;
    std::replace_if(
        comment.begin(),
        comment.end(),
        [](char letter) { return static_cast<unsigned char>(letter) < 0x20 || letter == 0x7F; },
        ' ');
    return (is_text_of_a_deck(comment) ? comment + "\n" : "") + write_toml(deck);
}

}  // namespace gxrod
