#include "deck/text/further_faults.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <string>
#include <tuple>

#include "deck/schema/schema_tables.hpp"
#include "deck/text/override_key.hpp"

namespace gxrod {
namespace {

using Steps = std::vector<KeyStep>;

const std::string* name_at(const Steps& steps, std::size_t i) {
    return i < steps.size() ? std::get_if<std::string>(&steps[i]) : nullptr;
}

KeyShape shape_of(const std::string& key) {
    const KeySpec* spec = deck_schema().find(key);
    return spec == nullptr ? KeyShape::value : spec->shape;
}

// Whether expressions read it by its name.
bool is_symbol(const std::string& key) {
    return key == "parameters" || key == "function" || key == "input" || key == "signal";
}

bool is_letter(char letter) { return letter == '_' || std::isalnum(static_cast<unsigned char>(letter)) != 0; }

// A name in the texts of others: "arm", "arm.end", "arm@0.5"; of a symbol any word of an expression.
bool names(const std::string& text, const std::string& name, bool is_word) {
    if (!is_word) {
        return text.starts_with(name) && (text.size() == name.size() || text[name.size()] == '.' ||
                                          text[name.size()] == '@' || text[name.size()] == '*');
    }
    for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + 1)) {
        const std::size_t end = at + name.size();
        if ((at == 0 || !is_letter(text[at - 1])) && (end == text.size() || !is_letter(text[end])))
            return true;
    }
    return false;
}

bool refers_to(const DeckNode& node, const std::string& name, bool is_word) {
    if (const std::string* text = node.text()) return names(*text, name, is_word);
    if (const DeckNode::Array* array = node.array())
        return std::ranges::any_of(*array,
                                   [&](const DeckNode& one) { return refers_to(one, name, is_word); });
    if (const DeckNode::Table* table = node.table()) {
        return std::ranges::any_of(*table,
                                   [&](const DeckEntry& one) { return refers_to(one.node, name, is_word); });
    }
    return false;
}

void erase(DeckNode& table, const std::string& key) {
    std::erase_if(*table.table(), [&](const DeckEntry& entry) { return entry.key == key; });
}

// A deck without what is wrong with it.
class Remainder {
  public:
    explicit Remainder(DeckNode deck) : deck_(std::move(deck)) {}

    const DeckNode& deck() const { return deck_; }

    // False if there is nothing that could be taken out.
    bool take_out(const DeckFault& fault) {
        const std::optional<Steps> steps = split_key(fault.key);
        if (!steps || steps->empty() || name_at(*steps, 0) == nullptr) return false;
        const std::string& kind = *name_at(*steps, 0);
        DeckEntry* entry = deck_.find(kind);
        if (entry == nullptr) return false;
        if (fault.message.starts_with("unknown key")) return take_out_key(*steps);
        switch (shape_of(kind)) {
            case KeyShape::named_tables:
            case KeyShape::parameters:
                return name_at(*steps, 1) != nullptr && take_out_named(kind, *name_at(*steps, 1));
            case KeyShape::table_list:
                return kind != "stage" && take_out_element(kind, *steps);
            case KeyShape::table:
                return take_out_value(*entry, *steps);
            default:
                erase(deck_, kind);
                return true;
        }
    }

    // With the numbers that the whole deck has.
    DeckFault renumbered(DeckFault fault) const {
        for (const auto& [list, numbers] : numbers_) {
            fault.key = renumbered(fault.key, list, numbers);
            fault.message = renumbered(fault.message, list, numbers);
        }
        return fault;
    }

    // Whether a fault of the remaining deck is one of the whole deck, too, as far as can be seen.
    bool is_sure(const DeckFault& fault) const {
        const std::optional<Steps> steps = split_key(fault.key);
        if (!steps || steps->empty() || name_at(*steps, 0) == nullptr) return false;
        if (is_stand_in_ && *name_at(*steps, 0) == "analysis") return false;
        const bool is_touched =
            touched_.contains(join_key(*steps, std::min<std::size_t>(2, steps->size()))) ||
            touched_.contains(*name_at(*steps, 0));
        // A list that lost its elements here is not missing there.
        if (steps->size() == 1 && numbers_.contains(*name_at(*steps, 0))) return false;
        const auto is_around = [&](const std::string& key) { return key.starts_with(fault.key); };
        if (std::ranges::any_of(taken_keys_, is_around)) return false;
        // What is missing there can have been meant by a key that was taken out.
        return !is_touched || (!fault.message.starts_with("missing") && find(*steps) != nullptr);
    }

  private:
    // An element's place in what remains; none if it is gone.
    std::optional<std::size_t> place_of(const std::string& list, std::size_t number) const {
        const auto numbers = numbers_.find(list);
        if (numbers == numbers_.end()) return number;
        const auto found = std::ranges::find(numbers->second, number);
        if (found == numbers->second.end()) return std::nullopt;
        return static_cast<std::size_t>(found - numbers->second.begin());
    }

    // The node at a path of the whole deck; nullptr if the remaining one has none.
    const DeckNode* find(const Steps& steps) const {
        const DeckNode* node = &deck_;
        for (std::size_t i = 0; i < steps.size(); ++i) {
            if (const std::string* key = std::get_if<std::string>(&steps[i])) {
                if (node->table() == nullptr) return nullptr;
                const DeckEntry* entry = node->find(*key);
                if (entry == nullptr) return nullptr;
                node = &entry->node;
                continue;
            }
            std::size_t index = std::get<std::size_t>(steps[i]);
            if (i == 1) {
                const std::optional<std::size_t> place = place_of(*name_at(steps, 0), index);
                if (!place) return nullptr;
                index = *place;
            }
            if (node->array() == nullptr || index >= node->array()->size()) return nullptr;
            node = &(*node->array())[index];
        }
        return node;
    }

    void touch(const Steps& steps) {
        const bool is_single = shape_of(*name_at(steps, 0)) == KeyShape::table || steps.size() == 1;
        touched_.insert(join_key(steps, is_single ? 1 : 2));
    }

    bool take_out_key(const Steps& steps) {
        const std::string* key = name_at(steps, steps.size() - 1);
        const Steps above(steps.begin(), steps.end() - 1);
        auto* table = const_cast<DeckNode*>(find(above));
        if (key == nullptr || table == nullptr || table->table() == nullptr || table->find(*key) == nullptr)
            return false;
        erase(*table, *key);
        touch(steps);
        taken_keys_.push_back(join_key(steps, steps.size()));
        return true;
    }

    bool take_out_named(const std::string& kind, const std::string& name) {
        DeckEntry* tables = deck_.find(kind);
        if (tables == nullptr || tables->node.table() == nullptr || tables->node.find(name) == nullptr)
            return false;
        erase(tables->node, name);
        if (tables->node.table()->empty()) erase(deck_, kind);
        take_out_references(name, is_symbol(kind));
        return true;
    }

    bool take_out_element(const std::string& list, const Steps& steps) {
        DeckEntry* entry = deck_.find(list);
        const auto* number = steps.size() > 1 ? std::get_if<std::size_t>(&steps[1]) : nullptr;
        if (number == nullptr || entry->node.array() == nullptr) {
            erase(deck_, list);
            return true;
        }
        const std::optional<std::size_t> place = place_of(list, *number);
        if (!place || *place >= entry->node.array()->size()) return false;
        erase_element(*entry, *place);
        return true;
    }

    void erase_element(DeckEntry& list, std::size_t place) {
        DeckNode::Array& elements = *list.node.array();
        std::vector<std::size_t>& numbers = numbers_[list.key];
        if (numbers.empty()) {
            numbers.resize(elements.size());
            std::iota(numbers.begin(), numbers.end(), std::size_t{0});
        }
        elements.erase(elements.begin() + static_cast<std::ptrdiff_t>(place));
        numbers.erase(numbers.begin() + static_cast<std::ptrdiff_t>(place));
        if (elements.empty()) erase(deck_, std::string(list.key));
    }

    // Of a table that a deck has once: the key, or the whole table where what is wrong is that a key is
    // missing.
    bool take_out_value(DeckEntry& entry, const Steps& steps) {
        const std::string* key = name_at(steps, 1);
        touched_.insert(entry.key);
        if (key != nullptr && entry.node.table() != nullptr && entry.node.find(*key) != nullptr) {
            erase(entry.node, *key);
            return true;
        }
        if (entry.key == "analysis") return stand_in(entry.node);
        erase(deck_, std::string(entry.key));
        return true;
    }

    // An analysis of the same kind in place of one that cannot be read.
    bool stand_in(DeckNode& analysis) {
        if (is_stand_in_) return false;
        is_stand_in_ = true;
        const auto has = [&](const char* key) {
            return analysis.table() != nullptr && analysis.find(key) != nullptr;
        };
        const bool is_timed = has("end_time") || has("time_step") || deck_.find("initial") != nullptr ||
                              (has("kind") && analysis.find("kind")->node.text() != nullptr &&
                               *analysis.find("kind")->node.text() == "dynamic");
        const auto entry = [&](const char* key, auto value) {
            return DeckEntry{key, analysis.place, DeckNode{std::move(value), analysis.place}};
        };
        DeckNode::Table table;
        table.push_back(entry("kind", std::string(is_timed ? "dynamic" : "static")));
        if (is_timed) {
            table.push_back(entry("end_time", 1.0));
            table.push_back(entry("steps", std::int64_t{10}));
        }
        analysis.value = std::move(table);
        return true;
    }

    // Whatever names it, and what names that in turn.
    void take_out_references(const std::string& name, bool is_word) {
        const auto refers = [&](const DeckNode& node) { return refers_to(node, name, is_word); };
        std::vector<std::pair<std::string, std::string>> tables;
        std::vector<std::string> keys;
        for (DeckEntry& entry : *deck_.table()) {
            const KeyShape shape = shape_of(entry.key);
            if (shape == KeyShape::named_tables || shape == KeyShape::parameters) {
                if (entry.node.table() == nullptr) continue;
                for (const DeckEntry& one : *entry.node.table()) {
                    if (refers(one.node)) tables.emplace_back(entry.key, one.key);
                }
            } else if (shape == KeyShape::table_list && entry.node.array() != nullptr &&
                       entry.key != "stage") {
                for (std::size_t i = entry.node.array()->size(); i-- > 0;) {
                    if (!refers((*entry.node.array())[i])) continue;
                    if (entry.node.array()->size() == 1) {
                        keys.push_back(entry.key);
                        break;
                    }
                    erase_element(entry, i);
                }
            } else if (shape == KeyShape::table && entry.node.table() != nullptr) {
                const auto count = std::erase_if(*entry.node.table(),
                                                 [&](const DeckEntry& one) { return refers(one.node); });
                if (count > 0) touched_.insert(entry.key);
            } else if (refers(entry.node)) {
                keys.push_back(entry.key);
            }
        }
        for (const std::string& key : keys) erase(deck_, key);
        for (const auto& [kind, one] : tables) take_out_named(kind, one);
    }

    // "load[1]" as it is numbered in the whole deck.
    static std::string renumbered(const std::string& text,
                                  const std::string& list,
                                  const std::vector<std::size_t>& numbers) {
        std::string result;
        std::size_t from = 0;
        const std::string head = list + "[";
        for (std::size_t at = text.find(head); at != std::string::npos; at = text.find(head, from)) {
            const std::size_t digits = at + head.size();
            std::size_t end = digits;
            while (end < text.size() && std::isdigit(static_cast<unsigned char>(text[end])) != 0) ++end;
            result += text.substr(from, digits - from);
            const bool is_number = end > digits && end - digits < 9 && (at == 0 || !is_letter(text[at - 1]));
            const std::size_t index =
                is_number ? std::stoul(text.substr(digits, end - digits)) : numbers.size();
            result += index < numbers.size() ? fmt::format("{}", numbers[index])
                                             : text.substr(digits, end - digits);
            from = end;
        }
        return result + text.substr(from);
    }

    DeckNode deck_;
    std::map<std::string, std::vector<std::size_t>> numbers_;  // of lists: of each element that is left
    std::set<std::string> touched_;  // tables from which a key was taken: "analysis", "rod.arm", "load[1]"
    std::vector<std::string> taken_keys_;  // unknown ones
    bool is_stand_in_ = false;
};

bool is_same(const DeckFault& a, const DeckFault& b) {
    return std::tie(a.file, a.line, a.column, a.key, a.message) ==
           std::tie(b.file, b.line, b.column, b.key, b.message);
}

}  // namespace

std::vector<DeckFault> find_further_faults(std::vector<DeckFault> first,
                                           DeckNode deck,
                                           const std::function<void(const DeckNode& deck)>& build) {
    constexpr int most_rounds = 8;
    Remainder rest(std::move(deck));
    std::vector<DeckFault> all = first;
    std::vector<DeckFault> latest = std::move(first);
    for (int round = 0; round < most_rounds; ++round) {
        bool is_changed = false;
        for (const DeckFault& fault : latest) is_changed = rest.take_out(fault) || is_changed;
        if (!is_changed) break;
        latest.clear();
        try {
            build(rest.deck());
        } catch (const DeckError& error) {
            for (const DeckFault& fault : error.faults) latest.push_back(rest.renumbered(fault));
        } catch (const std::exception&) {
            // Said when the deck is read the next time.
        }
        for (const DeckFault& fault : latest) {
            const bool is_known =
                std::ranges::any_of(all, [&](const DeckFault& other) { return is_same(other, fault); });
            if (!is_known && rest.is_sure(fault)) all.push_back(fault);
        }
    }
    // Those of --set, which have no line, come last.
    std::ranges::stable_sort(all, {}, [](const DeckFault& fault) {
        return std::tuple(fault.line == 0, fault.line, fault.column);
    });
    return all;
}

}  // namespace gxrod
