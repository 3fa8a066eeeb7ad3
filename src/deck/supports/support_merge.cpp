#include "deck/supports/support_merge.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "deck/loads/acting.hpp"
#include "deck/places/axes.hpp"
#include "deck/schema/choices.hpp"
#include "deck/schema/suggestion.hpp"
#include "deck/supports/components.hpp"

namespace gxrod {
namespace {

// Beyond which entries of the axes of two supports differ.
constexpr double same_axes = 1e-9;

// The key that says what follows a vessel.
Place place_of_follower(const SupportTable& table) {
    return table.fix ? table.place_of(&table.fix) : table.place_of(&table.vessel);
}

void follow(const SupportTable& table,
            std::size_t component,
            NodeSupport& merged,
            const BuildContext& context) {
    if (merged.support.fixed[component] || merged.support.moved[component]) {
        return context.faults.add(
            place_of_follower(table),
            table.path_of(&table.vessel),
            fmt::format("{} holds {} here too", merged.holders[component]->path, component_names[component]));
    }
    merged.support.moved[component] = true;  // by move_with_vessels
    merged.holders[component] = &table;
}

void follow_vessel(const SupportTable& table, NodeSupport& merged, const BuildContext& context) {
    const auto vessels = context.deck.tables("vessel");
    if (std::ranges::find(vessels, table.vessel->word, &CheckedTable::name) == vessels.end()) {
        std::vector<std::string> known;
        for (const CheckedTable& vessel : vessels) known.push_back(vessel.name);
        context.add_fault(table,
                          table.vessel,
                          fmt::format("no vessel \"{}\"; the deck has {}",
                                      table.vessel->word,
                                      known.empty() ? "none" : plain_list(known)));
    }
    for (const int component : components_on_vessel(table, context))
        follow(table, static_cast<std::size_t>(component), merged, context);
}

// Tables at one node have the same axes.
void merge_axes(const SupportTable& table, NodeSupport& merged, const BuildContext& context) {
    const Quat axes = find_axes(table, table.axes, context);
    if (merged.tables.empty()) {
        merged.support.axes = axes;
        return;
    }
    const Mat3 difference = axes.toRotationMatrix() - merged.support.axes.toRotationMatrix();
    if (difference.cwiseAbs().maxCoeff() <= same_axes) return;
    context.add_fault(
        table,
        table.axes,
        fmt::format("{} is at the same node and has other axes; supports of one node share theirs",
                    merged.tables.front()->path));
}

void fix(const SupportTable& table,
         const CheckedWord& word,
         NodeSupport& merged,
         const BuildContext& context) {
    const std::array<bool, 6> components = components_of(word.word);
    for (std::size_t i = 0; i < 6; ++i) {
        if (!components[i]) continue;
        if (merged.support.moved[i]) {
            return context.faults.add(
                word.place,
                word.path,
                fmt::format("{} moves {} here; a component is fixed or moved, never both",
                            merged.holders[i]->path,
                            component_names[i]));
        }
        merged.support.fixed[i] = true;
        if (merged.holders[i] == nullptr) merged.holders[i] = &table;
    }
}

void move(const SupportTable& table,
          std::size_t component,
          const CheckedTimeFunction& value,
          NodeSupport& merged,
          const BuildContext& context) {
    const bool is_fixed = merged.support.fixed[component];
    if (is_fixed || merged.support.moved[component]) {
        const SupportTable* holder = merged.holders[component];
        const std::string who = holder == &table ? "this support" : holder->path;
        return context.faults.add(
            value.place,
            value.path,
            is_fixed ? fmt::format("{} fixes {} here; a component is fixed or moved, never both",
                                   who,
                                   component_names[component])
                     : fmt::format("{} moves {} here too", who, component_names[component]));
    }
    merged.support.moved[component] = true;
    merged.support.motion[component] = find_acting(context).apply(value.function);
    merged.holders[component] = &table;
}

}  // namespace

std::vector<int> components_on_vessel(const SupportTable& table, const BuildContext& context) {
    std::array<bool, 6> followed{};
    if (!table.fix) followed = components_of("position");
    for (std::size_t i = 0; table.fix && i < table.fix->words.size(); ++i) {
        const std::array<bool, 6> named = components_of(table.fix->words[i].word);
        for (std::size_t k = 0; k < 6; ++k) followed[k] = followed[k] || named[k];
    }
    std::vector<int> components;
    for (int i = 0; i < 6; ++i) {
        const bool is_across = context.model.plane && context.model.plane->holds(i);
        if (followed[static_cast<std::size_t>(i)] && !is_across) components.push_back(i);
    }
    return components;
}

void merge_support(const SupportTable& table, NodeSupport& merged, const BuildContext& context) {
    merge_axes(table, merged, context);
    merged.tables.push_back(&table);
    if (table.vessel) return follow_vessel(table, merged, context);
    if (table.fix) {
        for (const CheckedWord& word : table.fix->words) fix(table, word, merged, context);
    }
    for (std::size_t i = 0; i < 6; ++i) {
        if (table.yields(i) && merged.yielding[i] == nullptr) merged.yielding[i] = &table;
        if (!table.move) continue;
        const std::optional<CheckedTimeFunction>& component = table.move->components[i];
        if (component) move(table, i, *component, merged, context);
    }
}

void check_yielding(const NodeSupport& merged, const BuildContext& context) {
    for (std::size_t i = 0; i < 6; ++i) {
        if (merged.yielding[i] == nullptr || merged.holders[i] == nullptr) continue;
        const SupportTable& spring = *merged.yielding[i];
        const SupportTable& holder = *merged.holders[i];
        const bool is_same = &spring == &holder;
        const bool is_stiff = spring.stiffness && spring.stiffness->values[i] > 0.0;
        const ComponentNumbers& numbers = is_stiff ? *spring.stiffness : *spring.damping;
        context.add_fault(
            numbers,
            numbers.values[i],
            fmt::format("{} {} {} here too; a component is fixed, moved or yields; expected it in one place",
                        is_same ? "this support" : holder.path,
                        merged.support.fixed[i] ? "fixes" : "moves",
                        component_names[i]));
    }
}

}  // namespace gxrod
