#include "watch/quantities.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <stdexcept>

namespace gxrod {

using Tables = std::vector<const QuantityTable*>;

namespace {

struct WatchedKind {
    std::string_view table;  // of the deck
    std::string_view noun;
    Tables tables;
};

// Lists the kinds of things in the order of Watched, whose last is a tie of any kind.
const std::vector<WatchedKind>& list_kinds() {
    static const std::vector<WatchedKind> kinds = [] {
        // clang-format off
        std::vector<WatchedKind> all{
            {"rod", "point", {&quantities_of_places, &quantities_of_rod_turns, &quantities_of_rates, &quantities_of_sections,
                              &quantities_of_stresses, &quantities_of_reactions, &quantities_of_rods_around}},
            {"body", "point", {&quantities_of_places, &quantities_of_body_turns, &quantities_of_rates, &quantities_of_bodies,
                               &quantities_of_reactions, &quantities_of_bodies_around, &quantities_of_touching_bodies}},
            {"tendon", "tendon", {&quantities_of_tendons}},
            {"obstacle", "obstacle", {&quantities_of_obstacles}},
            {"contact", "rod", {&quantities_of_touching_rods, &quantities_of_lying_rods}}};
        // clang-format on
        assert(all.size() + 1 == std::variant_size_v<Watched>);
        for (std::size_t kind = 0; kind < tie_kind_count; ++kind)
            all.push_back({tie_cards[kind].table, tie_cards[kind].table, {quantities_of_ties[kind]}});
        return all;
    }();
    return kinds;
}

const WatchedKind& kind_of(const Watched& target) {
    const auto* tie = std::get_if<WatchedTie>(&target);
    return list_kinds()[target.index() + (tie != nullptr ? static_cast<std::size_t>(tie->kind) : 0)];
}

const Quantity* find_line(const Tables& tables, std::string_view word) {
    for (const QuantityTable* table : tables) {
        const auto found = std::ranges::find(table->lines, word, &Quantity::word);
        if (found != table->lines.end()) return &*found;
    }
    return nullptr;
}

const QuantityTable& table_of(const Quantity& quantity) {
    const auto has_it = [&](const QuantityTable* table) {
        return std::ranges::any_of(table->lines, [&](const Quantity& line) { return &line == &quantity; });
    };
    return **std::ranges::find_if(list_quantity_tables(), has_it);
}

std::vector<std::string> words_of(const Tables& tables) {
    std::vector<std::string> words;
    for (const QuantityTable* table : tables) {
        for (const Quantity& line : table->lines) {
            if (std::ranges::find(words, line.word) == words.end()) words.emplace_back(line.word);
        }
    }
    return words;
}

}  // namespace

// clang-format off
const Tables& list_quantity_tables() {
    static const Tables tables = [] {
        Tables all{&quantities_of_places, &quantities_of_rod_turns, &quantities_of_body_turns, &quantities_of_rates,
                   &quantities_of_bodies, &quantities_of_sections, &quantities_of_stresses, &quantities_of_reactions};
        for (const QuantityTable* table : quantities_of_ties) {
            if (std::ranges::find(all, table) == all.end()) all.push_back(table);
        }
        all.insert(all.end(), {&quantities_of_rods_around, &quantities_of_bodies_around, &quantities_of_tendons,
                               &quantities_of_obstacles, &quantities_of_touching_rods, &quantities_of_touching_bodies,
                               &quantities_of_lying_rods});
        return all;
    }();
    return tables;
}
// clang-format on

const Quantity* find_quantity(const Watched& target, std::string_view word) {
    return find_line(kind_of(target).tables, word);
}

const Quantity* find_quantity(std::string_view word) { return find_line(list_quantity_tables(), word); }

const Quantity& quantity_of(const Watched& target, std::string_view word) {
    if (const Quantity* quantity = find_quantity(target, word)) return *quantity;
    throw std::invalid_argument(fmt::format("this {} has no quantity \"{}\"", kind_of(target).noun, word));
}

std::vector<const Quantity*> quantities_of(const HistoryRequest& request) {
    std::vector<const Quantity*> quantities;
    for (const std::string& word : request.quantities)
        quantities.push_back(&quantity_of(request.target, word));
    return quantities;
}

std::vector<std::string> list_quantity_words() { return words_of(list_quantity_tables()); }

std::vector<std::string> list_quantity_words(std::string_view table) {
    const auto found = std::ranges::find(list_kinds(), table, &WatchedKind::table);
    assert(found != list_kinds().end());
    return words_of(found->tables);
}

std::string explain_missing(std::string_view word, const Watched& target, const Model& model) {
    if (const Quantity* quantity = find_quantity(target, word))
        return quantity->lack != nullptr ? quantity->lack(target, model) : "";
    const WatchedKind& kind = kind_of(target);
    const QuantityTable& other = table_of(*find_quantity(word));
    if (&other == &quantities_of_tendons) return "only tendons have it";
    if (&other == &quantities_of_obstacles && !std::holds_alternative<WatchedTendon>(target))
        return "only obstacles have it, and rods as a whole, and bodies that touch";
    if (const char* own = kind.tables.front()->own; *own != '\0') return own;
    const bool is_of_rods = &other == &quantities_of_sections || &other == &quantities_of_rods_around ||
                            &other == &quantities_of_rod_turns;
    if (is_of_rods && std::holds_alternative<WatchedBody>(target))
        return "only points of rods have it; this one is a body";
    if (&other == &quantities_of_bodies && std::holds_alternative<WatchedPoint>(target))
        return "only bodies have it; this is a point of a rod";
    return fmt::format("only {} have it; this is a {}", other.owners, kind.noun);
}

bool can_be_relative(std::string_view word, const Watched& target) {
    const bool has_own_axes =
        is_tie(target, TieKind::bushing) || std::holds_alternative<WatchedTendon>(target) ||
        std::holds_alternative<WatchedObstacle>(target) || std::holds_alternative<WatchedContacts>(target);
    const Quantity& quantity = *find_quantity(word);
    return !has_own_axes && (quantity.axes == Axes::observer || quantity.is_from_no_load);
}

SnapshotPart part_of(const Quantity& quantity) { return table_of(quantity).part; }

const char* dimension_of(const Quantity& quantity, const Watched& target, const Model& model) {
    return quantity.dimension_of != nullptr ? quantity.dimension_of(target, model) : quantity.dimension;
}

}  // namespace gxrod
