#include "deck/places/build_context.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/rod_mesh.hpp"

namespace gxrod {
namespace {

// The point at nodes[index], where `nodes` goes from the rod's start to its end and may meet a node twice.
PlacedPoint make_point(const Rod& rod,
                       int rod_index,
                       const std::vector<int>& nodes,
                       std::size_t index,
                       const std::vector<MemberHinge>& hinges) {
    PlacedPoint point{.node = nodes[index], .rod = rod_index};
    auto position = std::find(rod.nodes.begin(), rod.nodes.end(), point.node);
    // All members of a mesh can have hinges at the node, and nodes of their own.
    for (auto hinge = hinges.begin(); position == rod.nodes.end() && hinge != hinges.end(); ++hinge) {
        if (hinge->node == point.node && hinge->rod == rod_index)
            position = std::find(rod.nodes.begin(), rod.nodes.end(), hinge->own_node);
    }
    point.position_in_rod = static_cast<int>(position - rod.nodes.begin());
    if (std::count(nodes.begin(), nodes.end(), point.node) < 2) return point;
    if (index == 0) point.end_element = 0;
    if (index + 1 == nodes.size()) {
        point.end_element = rod.element_count() - 1;
        point.is_end_of_rod = true;
    }
    return point;
}

}  // namespace

std::optional<PlacedPoint> BuildContext::place(const std::string& point) const {
    const auto found = names.find(point, PointNeeds::place);
    const Point* named = std::get_if<Point>(&found);
    return named == nullptr ? std::nullopt : place(*named);
}

std::optional<PlacedPoint> BuildContext::place(const Point& point) const {
    if (const auto* of_body = std::get_if<BodyPoint>(&point)) {
        const bool is_built = static_cast<std::size_t>(of_body->body) < body_nodes.size();
        const int node = is_built ? body_nodes[of_body->body] : -1;
        if (node < 0) return std::nullopt;
        return PlacedPoint{.node = node, .body = of_body->body};
    }
    const auto& [rod, fraction, meshed_position] = std::get<RodPoint>(point);
    const std::vector<int>& nodes = rod_nodes.empty() ? model.rods[rod].nodes : rod_nodes[rod];
    if (meshed_position >= 0) {
        if (nodes.empty()) return std::nullopt;
        PlacedPoint placed =
            make_point(model.rods[rod], rod, nodes, static_cast<std::size_t>(meshed_position), hinges);
        // A net of lines has no two ends.
        if (rod_fractions[rod].empty()) placed.end_element = -1;
        return placed;
    }
    const std::vector<double>& fractions = rod_fractions[rod];
    if (fractions.empty()) return std::nullopt;
    const auto nearest =
        std::min_element(fractions.begin(), fractions.end(), [at = fraction](double a, double b) {
            return std::abs(a - at) < std::abs(b - at);
        });
    const auto index = static_cast<std::size_t>(nearest - fractions.begin());
    PlacedPoint placed = make_point(model.rods[rod], rod, nodes, index, hinges);
    if (std::abs(*nearest - fraction) > same_fraction) placed.between = RodPoint{rod, fraction};
    return placed;
}

void BuildContext::reject_velocities(const Place& place, const std::string& path) const {
    const bool moves = std::ranges::any_of(stages, [](const StagePlan& one) {
        const auto* motion = std::get_if<DynamicSettings>(&one.analysis);
        return motion != nullptr && motion->has_inertia;
    });
    if (moves) {
        faults.add(place,
                   path,
                   "the first stage, " + stages.front().name + ", has no velocities; only dynamic ones have");
    } else {
        notes.push_back(path + ": without effect: velocities act in dynamic analyses, and the deck has none");
    }
}

bool BuildContext::needs_inertia() const {
    return std::any_of(stages.begin(), stages.end(), [](const StagePlan& one) {
        return gxrod::needs_inertia(one.analysis);
    });
}

Quat BuildContext::axes_at(const PlacedPoint& point) const {
    if (point.body >= 0) return model.bodies[point.body].attitude;
    const Rod& rod = model.rods[point.rod];
    return point.end_element > 0 ? rod.triads.back() : rod.triad_at(point.position_in_rod);
}

double BuildContext::twist_at(const PlacedPoint& point) const {
    if (point.body >= 0) return 0.0;
    const std::vector<double>& twists = rod_twists[static_cast<std::size_t>(point.rod)];
    if (twists.empty()) return 0.0;
    return point.end_element > 0 ? twists.back() : twists[static_cast<std::size_t>(point.position_in_rod)];
}

}  // namespace gxrod
