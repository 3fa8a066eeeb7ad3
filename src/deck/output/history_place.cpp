#include "deck/output/history_place.hpp"

#include <span>

#include "deck/places/part.hpp"
#include "mesh/rod_mesh.hpp"

namespace gxrod {
namespace {

// A node's place in the rod; where elements meet, in the first of them.
RodPlace place_in_rod(const PlacedPoint& point, const Rod& rod) {
    const auto per_element = static_cast<std::size_t>(rod.order) + 1;
    if (point.end_element >= 0) {
        return {point.rod, point.end_element, point.is_end_of_rod ? 1.0 : -1.0};
    }
    const auto found = std::find(rod.element_nodes.begin(), rod.element_nodes.end(), point.node);
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

}  // namespace

std::optional<HistoryPlace> find_history_place(const std::string& text, const BuildContext& context) {
    if (find_index(context.deck.tables("spring"), text)) {
        const std::optional<int> spring = find_tie(context.model.springs, text);
        if (!spring) return std::nullopt;
        return HistoryPlace{-1, -1, std::nullopt, *spring};
    }
    if (find_index(context.deck.tables("bushing"), text)) {
        const std::optional<int> bushing = find_tie(context.model.bushings, text);
        if (!bushing) return std::nullopt;
        return HistoryPlace{-1, -1, std::nullopt, -1, *bushing};
    }
    if (find_index(context.deck.tables("joint"), text)) {
        HistoryPlace place{-1, -1, std::nullopt};
        if (const std::optional<int> joint = find_tie(context.model.joints, text)) {
            place.joint = *joint;
        } else if (const std::optional<int> sleeve = find_tie(context.model.sleeves, text)) {
            place.sleeve = *sleeve;
        } else {
            return std::nullopt;
        }
        return place;
    }
    if (find_index(context.deck.tables("gear"), text)) {
        const std::optional<int> gear = find_tie(context.model.gears, text);
        if (!gear) return std::nullopt;
        HistoryPlace place{-1, -1, std::nullopt};
        place.gear = *gear;
        return place;
    }
    if (find_index(context.deck.tables("tendon"), text)) {
        const std::optional<int> tendon = find_tie(context.model.tendons, text);
        if (!tendon) return std::nullopt;
        HistoryPlace place{-1, -1, std::nullopt};
        place.tendon = *tendon;
        return place;
    }
    if (find_index(context.deck.tables("obstacle"), text)) {
        const std::optional<int> obstacle = find_tie(context.model.contact.obstacles, text);
        if (!obstacle) return std::nullopt;
        HistoryPlace place{-1, -1, std::nullopt};
        place.obstacle = *obstacle;
        return place;
    }
    const std::optional<int> whole = find_tie(context.model.rods, text);
    if (whole && !context.model.contact.is_empty()) {
        HistoryPlace place{-1, -1, std::nullopt};
        place.touching_rod = *whole;
        return place;
    }
    const std::optional<PlacedPoint> placed = context.place(text);
    if (!placed) return std::nullopt;
    if (placed->body >= 0) return HistoryPlace{placed->node, placed->body, std::nullopt};
    const Rod& rod = context.model.rods[static_cast<std::size_t>(placed->rod)];
    if (!placed->between) return HistoryPlace{placed->node, -1, place_in_rod(*placed, rod)};
    return HistoryPlace{-1, -1, place_between_nodes(*placed->between, rod)};
}

}  // namespace gxrod
