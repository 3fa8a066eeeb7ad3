#include "deck/output/build_output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <set>

#include "deck/contact/build_contact_exceptions.hpp"
#include "deck/output/build_output_times.hpp"
#include "deck/output/history_place.hpp"
#include "deck/rods/rod_table.hpp"
#include "deck/schema/choices.hpp"
#include "deck/schema/suggestion.hpp"
#include "deck/schema/synonyms.hpp"
#include "deck/sections/section_axes.hpp"
#include "model/settings/frame_interval.hpp"
#include "watch/quantities.hpp"

namespace gxrod {
namespace {

bool is_group_name(const std::string& name) {
    return !name.empty() && std::all_of(name.begin(), name.end(), [](char letter) {
        return letter == '_' || letter == '-' || std::isalnum(static_cast<unsigned char>(letter)) != 0;
    });
}

void check_name(const CheckedTable& history, std::set<std::string>& taken, const BuildContext& context) {
    const std::string& name = history.get<std::string>("name");
    if (!is_group_name(name)) {
        return context.add_fault(
            history, "name", fmt::format("expected a name of letters, digits, _ and -, found \"{}\"", name));
    }
    constexpr std::array taken_words{"time", "stage", "load_factor", "limit_load_factor", "branch"};
    if (std::find(taken_words.begin(), taken_words.end(), name) != taken_words.end()) {
        return context.add_fault(
            history, "name", fmt::format("\"{}\" is taken: a column of all histories has it", name));
    }
    if (!taken.insert(name).second) {
        context.add_fault(history, "name", fmt::format("an earlier history is named \"{}\" too", name));
    }
}

// Sets what the quantities are relative to; nothing if the deck does not say.
void set_reference(const CheckedTable& table, HistoryRequest& request, const BuildContext& context) {
    if (!table.gives("relative_to")) return;
    const std::optional<PlacedPoint> point = context.place(table.get<std::string>("relative_to"));
    if (!point) return;
    request.relative_to = table.get<std::string>("relative_to");
    request.relative_node = point->node;
    request.relative_axes = context.axes_at(*point);
    if (table.get<std::string>("axes") == section_axes_word) return;
    if (point->body >= 0)
        context.add_fault(table, "axes", "only sections of rods have a twist; this point is a body's");
    if (point->rod >= 0 && rods_of(context.deck)[static_cast<std::size_t>(point->rod)].get().mesh)
        context.add_fault(table, "axes", "a rod from a mesh has its section axes only");
    request.relative_to += ", untwisted";
    request.relative_axes = twisted(request.relative_axes, -context.twist_at(*point));
}

template <class Predicate>
bool asks_for(const HistoryRequest& request, Predicate&& is_meant) {
    return std::ranges::any_of(request.quantities, [&](const std::string& word) {
        const Quantity* quantity = find_quantity(request.target, word);
        return is_meant(quantity != nullptr ? *quantity : *find_quantity(word));
    });
}

void set_about(const CheckedTable& table, HistoryRequest& request, const BuildContext& context) {
    if (!table.gives("about")) return;
    request.about = table.get<Vec3>("about");
    if (!asks_for(request, [](const Quantity& one) { return one.is_about; }))
        context.add_fault(table, "about", "goes with reaction_moment, which is not among the quantities");
}

// A rod, or a body that touches, as ContactTouch has them.
std::optional<int> find_touching(const std::string& name, const Model& model) {
    if (const std::optional<int> rod = find_tie(model.rods, name)) return rod;
    const std::optional<int> body = find_tie(model.bodies, name);
    const auto& shapes = model.contact.bodies;
    if (!body || std::ranges::find(shapes, *body, &ContactBody::body) == shapes.end()) return std::nullopt;
    return static_cast<int>(model.rods.size()) + *body;
}

// Sets the only thing that counts as touching the rod or body `name`: the key `with`.
void set_other(const CheckedTable& table,
               const std::string& name,
               bool is_body,
               ContactWatch& contact,
               const BuildContext& context) {
    const Model& model = context.model;
    const std::string& with = table.get<std::string>("with");
    if (const std::optional<int> obstacle = find_tie(model.contact.obstacles, with)) {
        contact.other = -1 - *obstacle;
        if (is_left_out(model.contact, contact.rod, -1 - *obstacle))
            context.add_fault(
                table,
                "with",
                fmt::format("\"{}\" does not touch \"{}\": [[contact.pair]] leaves it out", name, with));
    } else if (const std::optional<int> other = find_touching(with, model)) {
        contact.other = *other;
        const bool is_itself = *other == contact.rod;
        const bool is_off = is_left_out(model.contact, contact.rod, *other);
        if (is_itself && is_body)
            context.add_fault(table, "with", "a body does not touch itself");
        else if (is_off || (is_itself ? !model.contact.within_rods : !model.contact.between_rods))
            context.add_fault(table,
                              "with",
                              fmt::format("\"{}\" does not touch {}: {} leaves it out",
                                          name,
                                          is_itself ? "itself"
                                          : is_off  ? "\"" + with + "\""
                                                    : "other rods",
                                          is_off ? "[[contact.pair]]" : "[contact]"));
    } else {
        std::vector<std::string> names;
        for (const Obstacle& one : model.contact.obstacles) names.push_back(one.name);
        for (const Rod& one : model.rods) names.push_back(one.name);
        for (const ContactBody& one : model.contact.bodies)
            names.push_back(model.bodies[static_cast<std::size_t>(one.body)].name);
        context.add_fault(
            table, "with", fmt::format("no obstacle and no rod \"{}\"{}", with, did_you_mean(with, names)));
    }
}

void set_contact(const CheckedTable& table, HistoryRequest& request, const BuildContext& context) {
    const Model& model = context.model;
    auto* body = std::get_if<WatchedBody>(&request.target);
    auto* rod = std::get_if<WatchedContacts>(&request.target);
    const bool is_body = body != nullptr && asks_for(request, [&](const Quantity& one) {
                             return part_of(one) == SnapshotPart::contact &&
                                    explain_missing(one.word, request.target, model).empty();
                         });
    if (rod == nullptr && !is_body) {
        if (table.gives("with"))
            context.add_fault(table,
                              "with",
                              "goes with a rod as a whole as `at`, or a body and contact quantities, in a "
                              "deck with contact");
        return;
    }
    const int index = is_body ? static_cast<int>(model.rods.size()) + body->index : rod->contact.rod;
    const std::string& name = is_body ? model.bodies[static_cast<std::size_t>(body->index)].name
                                      : model.rods[static_cast<std::size_t>(index)].name;
    if (!is_body && model.contact.radii[static_cast<std::size_t>(index)] == 0.0) {
        context.add_fault(table,
                          "at",
                          fmt::format("\"{}\" touches nothing; expected a point of it, as in \"{}@0.5\", or "
                                      "this rod among `rods` of [contact]",
                                      name,
                                      name));
        return;
    }
    ContactWatch& contact = is_body ? body->contact.emplace() : rod->contact;
    contact.rod = index;
    contact.wants_gap = asks_for(request, [](const Quantity& one) { return one.is_searched; });
    if (!table.gives("with")) return;
    request.with = table.get<std::string>("with");
    set_other(table, name, is_body, contact, context);
}

// '; did you mean "axial_force"?', of what the thing has instead of a word that means something else
// elsewhere; "" if nothing is meant.
std::string suggest_quantity(const std::string& word, const Watched& target, const Model& model) {
    std::vector<std::string> there = list_quantity_words();
    std::erase_if(there,
                  [&](const std::string& one) { return !explain_missing(one, target, model).empty(); });
    const std::string meant = find_choice(word, there);
    return meant.empty() ? "" : fmt::format("; did you mean \"{}\"?", meant);
}

void add_quantities(const CheckedTable& table, HistoryRequest& request, const BuildContext& context) {
    for (const CheckedWord& word : table.get<std::vector<CheckedWord>>("quantities")) {
        auto& listed = request.quantities;
        if (std::find(listed.begin(), listed.end(), word.word) != listed.end()) {
            context.faults.add(word.place, word.path, fmt::format("\"{}\" is listed twice", word.word));
            continue;
        }
        std::string reason = explain_missing(word.word, request.target, context.model);
        if (!reason.empty()) reason += suggest_quantity(word.word, request.target, context.model);
        if (table.gives("relative_to") && !can_be_relative(word.word, request.target))
            reason = "cannot be relative to a point; write another history for it";
        if (!reason.empty())
            context.faults.add(word.place, word.path, fmt::format("\"{}\": {}", word.word, reason));
        listed.push_back(word.word);
    }
}

HistoryRequest build_history(const CheckedTable& table, const Watched& target, const BuildContext& context) {
    HistoryRequest request{
        .name = table.get<std::string>("name"), .at = table.get<std::string>("at"), .target = target};
    set_reference(table, request, context);
    add_quantities(table, request, context);
    set_about(table, request, context);
    set_contact(table, request, context);
    return request;
}

}  // namespace

OutputSettings build_output(const BuildContext& context) {
    OutputSettings output;
    output.every = context.stages.front().frame_interval;
    const std::vector<CheckedTable>& tables = context.deck.tables("output");
    if (!tables.empty()) {
        const CheckedTable& table = tables.front();
        build_output_times(table, context, output);
        output.compression = value_of(compression_choices, table.get<std::string>("compression"));
    }
    std::set<std::string> taken;
    for (const CheckedTable& table : context.deck.tables("history")) {
        check_name(table, taken, context);
        const std::optional<Watched> target = find_watched(table.get<std::string>("at"), context);
        if (target) output.histories.push_back(build_history(table, *target, context));
    }
    return output;
}

}  // namespace gxrod
