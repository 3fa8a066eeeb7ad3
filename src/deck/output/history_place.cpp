#include "deck/output/history_place.hpp"

#include <span>

#include "deck/places/name_pattern.hpp"
#include "deck/places/part.hpp"
#include "deck/ties/ties.hpp"
#include "mesh/rod_mesh.hpp"

namespace gxrod {
namespace {

// A node's place in the rod; where elements meet, in the first of them.
RodPlace place_in_rod(const PlacedPoint& point, const Rod& rod) {
    const auto per_element = static_cast<std::size_t>(rod.order) + 1;
    if (point.end_element >= 0) {
        return {point.rod, point.end_element, point.is_end_of_rod ? 1.0 : -1.0};
    }
    const int node = rod.nodes[static_cast<std::size_t>(point.position_in_rod)];
    const auto found = std::find(rod.element_nodes.begin(), rod.element_nodes.end(), node);
    const auto entry = static_cast<std::size_t>(found - rod.element_nodes.begin());
    const double fraction = compute_element_nodes(rod.order)[entry % per_element];
    return {point.rod, static_cast<int>(entry / per_element), 2.0 * fraction - 1.0};
}

// The arc length at a fraction 0 … 1 of an element's interval of ξ; elements from meshes have their nodes at
// any.
double arc_length_at(const std::vector<double>& nodes, std::span<const double> arc_lengths, double fraction) {
    double sum = 0.0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        double shape = 1.0;
        for (std::size_t j = 0; j < nodes.size(); ++j) {
            if (j != i) shape *= (fraction - nodes[j]) / (nodes[i] - nodes[j]);
        }
        sum += shape * arc_lengths[i];
    }
    return sum;
}

// At a fraction of the length where there is no node.
RodPlace place_between_nodes(const RodPoint& point, const Rod& rod) {
    const double at = point.fraction * rod.length;
    const auto per_element = static_cast<std::size_t>(rod.order) + 1;
    const auto arc_lengths_of = [&](int element) {
        return std::span(rod.arc_length)
            .subspan(static_cast<std::size_t>(element) * per_element, per_element);
    };
    int element = 0;
    const auto has_it = [&](std::span<const double> s) { return s.front() <= at && at <= s.back(); };
    while (element + 1 < rod.element_count() && !has_it(arc_lengths_of(element))) ++element;
    const std::vector<double> nodes = compute_element_nodes(rod.order);
    double low = 0.0;
    double high = 1.0;
    constexpr int halvings = 60;
    for (int i = 0; i < halvings; ++i) {
        const double middle = 0.5 * (low + high);
        (arc_length_at(nodes, arc_lengths_of(element), middle) < at ? low : high) = middle;
    }
    return {point.rod, element, low + high - 1.0};
}

// The thing of that name as the model is built; nullopt without it.
template <class Thing>
std::optional<Watched> find_thing(const auto& things, const std::string& name) {
    const std::optional<int> index = find_named(things, name);
    if (!index) return std::nullopt;
    return Thing{*index};
}

// The tables whose names are things to watch, in a deck with contact or ground rods too.
std::vector<std::string> list_watched_tables(const BuildContext& context) {
    std::vector<std::string> tables = list_tie_words();
    tables.insert(tables.end(), {"tendon", "chamber", "obstacle"});
    const auto has = [&](const char* table) { return !context.deck.tables(table).empty(); };
    if (has("contact") || has("obstacle") || has("seabed")) tables.emplace_back("rod");
    return tables;
}

// The names of such tables that match a text.
std::vector<std::string> list_matching(const std::string& text, const BuildContext& context) {
    std::vector<std::string> names;
    for (const std::string& kind : list_watched_tables(context)) {
        for (const CheckedTable& table : context.deck.tables(kind)) {
            if (matches_pattern(table.name, text)) names.push_back(table.name);
        }
    }
    return names;
}

// What is not a point; nullopt if it could not be built.
std::optional<Watched> find_named_thing(const std::string& name, const BuildContext& context) {
    const Model& model = context.model;
    const auto names = [&](std::string_view table) {
        return find_index(context.deck.tables(table), name).has_value();
    };
    std::optional<Watched> tie;
    for_each_tie_list(model, [&](TieKind kind, const auto& list) {
        if (!names(card_of(kind).table)) return;
        if (const std::optional<int> index = find_named(list, name)) tie = WatchedTie{kind, *index};
    });
    if (tie) return tie;
    if (names("tendon") || names("chamber")) return find_thing<WatchedTendon>(model.tendons, name);
    if (names("obstacle")) return find_thing<WatchedObstacle>(model.contact.obstacles, name);
    const std::optional<int> whole = find_named(model.rods, name);
    if (whole && (!model.contact.is_empty() || model.surroundings.seabed))
        return WatchedContacts{{.rod = *whole}};
    return std::nullopt;
}

Watched watch_point(const PlacedPoint& placed, const Model& model) {
    if (placed.body >= 0) return WatchedBody{.index = placed.body, .node = placed.node};
    const Rod& rod = model.rods[static_cast<std::size_t>(placed.rod)];
    if (placed.between) return WatchedPoint{place_between_nodes(*placed.between, rod)};
    return WatchedPoint{place_in_rod(placed, rod), placed.node};
}

}  // namespace

std::vector<WatchedText> find_watched(const std::string& text, const BuildContext& context) {
    std::vector<WatchedText> found;
    const std::vector<std::string> named = list_matching(text, context);
    for (const std::string& name : named) {
        if (const std::optional<Watched> thing = find_named_thing(name, context))
            found.push_back({name, *thing});
    }
    if (!named.empty()) return found;
    const auto points = context.names.find_all(text, PointNeeds::place);
    const auto* all = std::get_if<std::vector<NamedPoint>>(&points);
    if (all == nullptr) return found;
    for (const NamedPoint& one : *all) {
        if (const std::optional<PlacedPoint> placed = context.place(one.point))
            found.push_back({one.text, watch_point(*placed, context.model)});
    }
    return found;
}

std::string explain_no_watched(const std::string& text, const BuildContext& context) {
    if (!list_matching(text, context).empty()) return "";
    const auto points = context.names.find_all(text, PointNeeds::place);
    const auto* message = std::get_if<std::string>(&points);
    return message == nullptr ? "" : *message;
}

}  // namespace gxrod
