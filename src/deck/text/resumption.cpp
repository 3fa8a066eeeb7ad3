#include "deck/text/resumption.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "deck/schema/schema.hpp"
#include "deck/schema/schema_tables.hpp"
#include "deck/text/deck_comparison.hpp"
#include "model/ties/ties.hpp"

namespace gxrod {
namespace {

// Differences of no matter to the state of a run.
const ComparisonRules& rules() {
    static const ComparisonRules rules = [] {
        ComparisonRules made{{}, "the run to be resumed has "};
        for (const KeySpec& key : deck_schema().keys) {
            if (key.may_change) made.free_paths.push_back(key.name);
        }
        for (const KeySpec& key : analysis_table().keys) {
            if (!key.may_change) continue;
            made.free_paths.push_back("analysis." + key.name);
            made.free_paths.push_back("stage[]." + key.name);
        }
        return made;
    }();
    return rules;
}

const DeckNode* find_history(const DeckNode::Array& histories, const DeckNode& wanted) {
    const auto name_of = [](const DeckNode& history) {
        const DeckEntry* name = history.table() == nullptr ? nullptr : history.find("name");
        return name == nullptr ? nullptr : name->node.text();
    };
    const std::string* name = name_of(wanted);
    for (const DeckNode& history : histories) {
        const std::string* other = name_of(history);
        if (name != nullptr && other != nullptr && *name == *other) return &history;
    }
    return nullptr;
}

DeckNode without_quantities(const DeckNode& history) {
    DeckNode rest = history;
    std::erase_if(*rest.table(), [](const DeckEntry& entry) { return entry.key == "quantities"; });
    return rest;
}

// Histories of one name must be of one point.
void compare_histories(const DeckNode& before, const DeckNode& now, FaultList& faults) {
    const DeckEntry* earlier = before.find("history");
    const DeckEntry* later = now.find("history");
    if (earlier == nullptr || later == nullptr) return;
    if (earlier->node.array() == nullptr || later->node.array() == nullptr) return;
    for (std::size_t i = 0; i < later->node.array()->size(); ++i) {
        const DeckNode& history = later->node.array()->at(i);
        const DeckNode* same = find_history(*earlier->node.array(), history);
        if (same == nullptr) continue;
        compare_decks(without_quantities(*same),
                      without_quantities(history),
                      rules(),
                      faults,
                      fmt::format("history[{}]", i));
    }
}

}  // namespace

void check_resumption(const DeckNode& before, const DeckNode& now, FaultList& faults) {
    compare_decks(before, now, rules(), faults);
    compare_histories(before, now, faults);
}

bool have_same_mesh(const Model& before, const Model& now) {
    const auto same_node = [](const Node& a, const Node& b) { return a.position == b.position; };
    const auto same_rod = [](const Rod& a, const Rod& b) {
        return a.name == b.name && a.kind == b.kind && a.order == b.order &&
               a.element_nodes == b.element_nodes;
    };
    const auto same_body = [](const Body& a, const Body& b) { return a.name == b.name && a.node == b.node; };
    const auto same_end = [](const Anchor& a, const Anchor& b) { return a.node == b.node && a.arm == b.arm; };
    const auto same_tie = [&](const Tie& a, const Tie& b) {
        return a.kind == b.kind && *a.name == *b.name && std::ranges::equal(a.ends, b.ends, same_end);
    };
    const auto same_joint = [&](const Joint& a, const Joint& b) {
        return a.kind == b.kind && a.a.axes == b.a.axes && a.b.axes == b.b.axes;
    };
    const auto same_sleeve = [](const Sleeve& a, const Sleeve& b) {
        return a.rod == b.rod && a.holds_turn == b.holds_turn;
    };
    const auto same_tendon = [&](const Tendon& a, const Tendon& b) {
        return a.name == b.name && a.winch.has_value() == b.winch.has_value() &&
               a.friction.has_value() == b.friction.has_value();
    };
    return std::ranges::equal(before.nodes, now.nodes, same_node) &&
           std::ranges::equal(before.rods, now.rods, same_rod) &&
           std::ranges::equal(before.bodies, now.bodies, same_body) &&
           std::ranges::equal(list_ties(before), list_ties(now), same_tie) &&
           std::ranges::equal(before.joints, now.joints, same_joint) &&
           std::ranges::equal(before.sleeves, now.sleeves, same_sleeve) &&
           std::ranges::equal(before.tendons, now.tendons, same_tendon);
}

}  // namespace gxrod
