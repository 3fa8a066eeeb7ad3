#include "deck/places/point_patterns.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <set>

namespace gxrod {
namespace {

// A point and its arc length.
struct PlaceCandidate {
    PlacedPoint point;
    double s = 0.0;
};

// The ends and corners of a rod, and the nodes between the elements of its mesh.
void add_rod_places(int index, const BuildContext& context, std::vector<PlaceCandidate>& candidates) {
    const auto i = static_cast<std::size_t>(index);
    const Rod& rod = context.model.rods[i];
    const std::vector<int>& nodes = context.rod_nodes[i];
    std::map<int, int> positions;  // the first entry of each node
    for (std::size_t k = 0; k < nodes.size(); ++k) positions.emplace(nodes[k], static_cast<int>(k));
    const bool is_meshed = context.names.is_meshed(index);
    const auto per_element = static_cast<std::size_t>(rod.order) + 1;
    std::set<int> added;
    const auto add = [&](std::size_t entry) {
        int node = rod.element_nodes[entry];
        const auto hinge = std::ranges::find(context.hinges, node, &MemberHinge::own_node);
        // In its place the node to which a hinge ties it, which is another rod's if the rod is not a mesh.
        if (hinge != context.hinges.end() && !is_meshed) return;
        if (hinge != context.hinges.end()) node = hinge->node;
        if (!added.insert(node).second) return;
        const auto placed = context.place(Point(RodPoint{index, 0.0, positions.at(node)}));
        if (placed) candidates.push_back({*placed, rod.arc_length[entry]});
    };
    for (std::size_t entry = 0; entry < rod.element_nodes.size(); entry += per_element) {
        const std::size_t last = entry + per_element - 1;
        const bool is_first = entry == 0 || is_meshed;
        if (is_first || is_corner(rod, entry)) add(entry);
        if (last + 1 == rod.element_nodes.size() || is_meshed) add(last);
    }
}

double arc_length_of(const PlacedPoint& point, const Model& model) {
    if (point.rod < 0) return 0.0;
    const Rod& rod = model.rods[static_cast<std::size_t>(point.rod)];
    const int node = rod.nodes[static_cast<std::size_t>(point.position_in_rod)];
    const auto entry = std::ranges::find(rod.element_nodes, node) - rod.element_nodes.begin();
    return rod.arc_length[static_cast<std::size_t>(entry)];
}

std::vector<PlaceCandidate> list_place_candidates(const std::optional<PointPatterns>& at,
                                                  bool takes_rods,
                                                  const BuildContext& context) {
    std::vector<PlaceCandidate> candidates;
    const auto add_rods = [&](const std::string& pattern) {
        const std::vector<int> rods = context.names.find_rods(pattern);
        for (const int rod : rods) add_rod_places(rod, context, candidates);
        return !rods.empty();
    };
    if (!at) add_rods("*");
    if (!at) return candidates;
    for (const CheckedWord& word : at->words) {
        if (takes_rods && add_rods(word.word)) continue;
        const auto found = context.names.find_all(word.word, PointNeeds::place);
        if (!std::holds_alternative<std::vector<NamedPoint>>(found)) continue;
        for (const NamedPoint& one : std::get<std::vector<NamedPoint>>(found)) {
            const std::optional<PlacedPoint> placed = context.place(one.point);
            if (placed) candidates.push_back({*placed, arc_length_of(*placed, context.model)});
        }
    }
    return candidates;
}

// "x 0 to 6, y 0 to 0, z 0 to 3.5".
std::string describe_range(const std::vector<PlaceCandidate>& candidates, const Model& model) {
    Eigen::AlignedBox3d box;
    for (const PlaceCandidate& one : candidates)
        box.extend(model.nodes[static_cast<std::size_t>(one.point.node)].position);
    return fmt::format("x {:.6g} to {:.6g}, y {:.6g} to {:.6g}, z {:.6g} to {:.6g}",
                       box.min()[0],
                       box.max()[0],
                       box.min()[1],
                       box.max()[1],
                       box.min()[2],
                       box.max()[2]);
}

bool satisfies(const PlaceCondition& where, const Vec3& position, double s, const BuildContext& context) {
    try {
        return where.holds(position, s);
    } catch (const EvaluationError& error) {
        context.add_evaluation_fault(where.value.place, where.value.path, error);
        return false;
    }
}

}  // namespace

bool is_corner(const Rod& rod, std::size_t entry) {
    constexpr double same_direction = 1e-6;
    if (entry == 0) return false;
    const Vec3 before = rod.triads[entry - 1] * Vec3::UnitX(), after = rod.triads[entry] * Vec3::UnitX();
    return (before - after).norm() > same_direction;
}

std::vector<PlacedPoint> find_points(const TableHead& table,
                                     const std::optional<PointPatterns>& at,
                                     const std::optional<PlaceCondition>& where,
                                     const BuildContext& context) {
    std::vector<PlaceCandidate> candidates = list_place_candidates(at, where.has_value(), context);
    std::set<int> nodes;
    std::erase_if(candidates,
                  [&](const PlaceCandidate& one) { return !nodes.insert(one.point.node).second; });
    std::vector<PlacedPoint> points;
    for (const PlaceCandidate& one : candidates) {
        const Vec3& position = context.model.nodes[static_cast<std::size_t>(one.point.node)].position;
        if (!where || satisfies(*where, position, one.s, context)) points.push_back(one.point);
    }
    if (where && points.empty() && !candidates.empty())
        context.add_fault(table,
                          where,
                          fmt::format("no point satisfies \"{}\"; the {} points here have {}",
                                      where->text,
                                      candidates.size(),
                                      describe_range(candidates, context.model)));
    return points;
}

std::vector<bool> select_elements(const Rod& rod, const PlaceCondition& where, const BuildContext& context) {
    const auto per_element = static_cast<std::size_t>(rod.order) + 1;
    std::vector<bool> selected;
    for (std::size_t entry = 0; entry < rod.element_nodes.size(); entry += per_element) {
        const std::size_t last = entry + per_element - 1;
        const auto position = [&](std::size_t i) -> const Vec3& {
            return context.model.nodes[static_cast<std::size_t>(rod.element_nodes[i])].position;
        };
        const Vec3 middle = 0.5 * (position(entry) + position(last));
        const double s = 0.5 * (rod.arc_length[entry] + rod.arc_length[last]);
        selected.push_back(satisfies(where, middle, s, context));
    }
    return selected;
}

}  // namespace gxrod
