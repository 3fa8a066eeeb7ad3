#include "face/variation.hpp"

#include <cmath>
#include <optional>
#include <stdexcept>

#include "deck/text/override_key.hpp"
#include "deck/text/overrides.hpp"
#include "face/deck.hpp"
#include "face/unknown_name_error.hpp"

namespace gxrod {
namespace {

// Relative to the number. Errors of differences along derivatives that are carried along are its fourth
// power.
constexpr double relative_step = 5e-4;

const DeckNode* find(const DeckNode& deck, const std::vector<KeyStep>& steps) {
    const DeckNode* node = &deck;
    for (const KeyStep& step : steps) {
        if (const auto* name = std::get_if<std::string>(&step)) {
            const DeckEntry* entry = node->table() != nullptr ? node->find(*name) : nullptr;
            if (entry == nullptr) return nullptr;
            node = &entry->node;
        } else {
            const DeckNode::Array* array = node->array();
            const std::size_t index = std::get<std::size_t>(step);
            if (array == nullptr || index >= array->size()) return nullptr;
            node = &(*array)[index];
        }
    }
    return node;
}

std::optional<double> number_of(const DeckNode& node) {
    if (const auto* whole = std::get_if<std::int64_t>(&node.value)) return static_cast<double>(*whole);
    if (const auto* number = std::get_if<double>(&node.value)) return *number;
    return std::nullopt;
}

// Finds the key of a parameter, or any other key, and its number in the deck with its overrides.
std::pair<std::string, double> find_number(const Deck& deck, const std::string& name) {
    DeckNode tree = deck.source()->tree();
    FaultList faults(deck.file(), deck.overrides());
    apply_overrides(deck.overrides(), tree, faults);
    faults.throw_if_any();
    for (const std::string& key : {"parameters." + name, name}) {
        const auto steps = split_key(key);
        if (!steps) continue;
        const DeckNode* node = find(tree, *steps);
        if (node == nullptr) continue;
        if (const std::optional<double> number = number_of(*node)) return {key, *number};
        throw std::invalid_argument(name + " is not a number; take derivatives by the parameters in it");
    }
    std::vector<std::string> parameters;
    const DeckEntry* table = tree.find("parameters");
    if (table != nullptr && table->node.table() != nullptr) {
        for (const DeckEntry& entry : *table->node.table()) parameters.push_back(entry.key);
    }
    find_name("number of the deck", name, parameters);
    return {};
}

}  // namespace

VariedNumber vary(const Deck& deck, const std::string& number) {
    const auto [key, value] = find_number(deck, number);
    const double step = relative_step * (value != 0.0 ? std::abs(value) : 1.0);
    const auto build = [&](double steps) { return Deck(deck).set(key, value + steps * step).build(); };
    return {number, {build(1.0), build(-1.0), build(2.0), build(-2.0)}, step};
}

}  // namespace gxrod
