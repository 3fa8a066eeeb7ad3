#include "deck/rods/coincident_points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "deck/places/point_patterns.hpp"
#include "deck/rods/rod_table.hpp"

namespace gxrod {
namespace {

// A node between elements.
struct JoinCandidate {
    JoinedPoint point;
    Vec3 position;
    double along = 0.0;     // the direction by which candidates are sorted
    bool is_point = false;  // not just between two elements
    bool is_grouped = false;
};

// Oblique, so that few points of a frame have the same component.
const Vec3 sorting_direction = Vec3(1.0, 0.61803, 0.36788).normalized();

// The nodes of a rod from a mesh in which curves of its geometry end; none of another rod.
std::set<int> find_curve_ends(int index, const RodNets& nets, const BuildContext& context) {
    std::set<int> ends;
    const auto named = nets.find(index);
    if (named == nets.end()) return ends;
    const std::vector<int>& nodes = context.rod_nodes[static_cast<std::size_t>(index)];
    for (const NetChain& chain : named->second.net.chains) {
        for (std::size_t e = 0; e < chain.elements.size(); ++e) {
            const NetElement& element = chain.elements[e];
            const bool is_last =
                e + 1 == chain.elements.size() || chain.elements[e + 1].curve != element.curve;
            if (e == 0) ends.insert(nodes[static_cast<std::size_t>(element.nodes.front())]);
            if (is_last) ends.insert(nodes[static_cast<std::size_t>(element.nodes.back())]);
        }
    }
    return ends;
}

void add_join_candidates(int index,
                         const RodNets& nets,
                         const BuildContext& context,
                         std::vector<JoinCandidate>& candidates) {
    const auto i = static_cast<std::size_t>(index);
    const Rod& rod = context.model.rods[i];
    const auto per_element = static_cast<std::size_t>(rod.order) + 1;
    const std::set<int> curve_ends = find_curve_ends(index, nets, context);
    std::set<int> added;
    // Instead of a node of its own that a hinge of a mesh has, the node to which it is tied.
    const auto node_of = [&](std::size_t entry) {
        const auto hinge =
            std::ranges::find(context.hinges, rod.element_nodes[entry], &MemberHinge::own_node);
        return hinge == context.hinges.end() ? rod.element_nodes[entry] : hinge->node;
    };
    const auto add = [&](std::size_t entry, bool is_point) {
        const int node = node_of(entry);
        if (!added.insert(node).second) return;
        const Node& at = context.model.nodes[static_cast<std::size_t>(node)];
        is_point = is_point || curve_ends.contains(node) || at.name.find(" node ") == std::string::npos;
        candidates.push_back({make_joined(at.name, {.node = node, .rod = index}, context),
                              at.position,
                              at.position.dot(sorting_direction),
                              is_point});
    };
    for (std::size_t entry = 0; entry < rod.element_nodes.size(); entry += per_element) {
        const std::size_t next = entry + per_element;
        add(entry, entry == 0 || is_corner(rod, entry));
        add(next - 1, next == rod.element_nodes.size() || is_corner(rod, next));
    }
}

// The candidates that coincide with the first of those that are sorted; itself included.
std::vector<JoinCandidate*> take_group(std::vector<JoinCandidate>& sorted,
                                       std::size_t first,
                                       double tolerance) {
    std::vector<JoinCandidate*> group;
    for (std::size_t k = first; k < sorted.size() && sorted[k].along - sorted[first].along <= tolerance;
         ++k) {
        JoinCandidate& other = sorted[k];
        if (!other.is_grouped && (other.position - sorted[first].position).norm() <= tolerance)
            group.push_back(&other);
    }
    return group;
}

// The share of an element, as a straight line, at which a place lies on it between its ends.
std::optional<double> find_share(const Vec3& place, const Vec3& from, const Vec3& to, double tolerance) {
    const Vec3 along = to - from;
    const double share = (place - from).dot(along) / along.squaredNorm();
    const bool is_between = share > 0.0 && share < 1.0;
    if (!is_between || (from + share * along - place).norm() > tolerance) return std::nullopt;
    return share;
}

// Where on a rod a place lies between nodes: "column at 0.37 of its length"; "" if it does not.
std::string describe_place_on(const Rod& rod, const Vec3& place, double tolerance, const Model& model) {
    const auto per_element = static_cast<std::size_t>(rod.order) + 1;
    for (std::size_t entry = 0; entry < rod.element_nodes.size(); entry += per_element) {
        const std::size_t last = entry + per_element - 1;
        const auto position = [&](std::size_t i) {
            return model.nodes[static_cast<std::size_t>(rod.element_nodes[i])].position;
        };
        const auto share = find_share(place, position(entry), position(last), tolerance);
        if (!share) continue;
        const double s = std::lerp(rod.arc_length[entry], rod.arc_length[last], *share);
        return fmt::format("{} at {:.6g} of its length", rod.name, s / rod.length);
    }
    return "";
}

}  // namespace

JoinedPoint make_joined(std::string name, const PlacedPoint& point, const BuildContext& context) {
    JoinedPoint joined{std::move(name), point.node, point.rod};
    const auto i = static_cast<std::size_t>(point.rod);
    const RodTable& table = rods_of(context.deck)[i];
    if (table.mesh) return joined;
    const std::vector<int>& nodes = context.model.rods[i].nodes;
    joined.is_hinged = (point.node == nodes.front() && has_hinge(table, "start")) ||
                       (point.node == nodes.back() && has_hinge(table, "end"));
    return joined;
}

std::string explain_loose_end(const std::vector<int>& rods,
                              double tolerance,
                              const std::vector<std::vector<JoinedPoint>>& groups,
                              const BuildContext& context) {
    std::set<int> joined;
    for (const std::vector<JoinedPoint>& group : groups) {
        for (const JoinedPoint& one : group) joined.insert(one.node);
    }
    const Model& model = context.model;
    for (const int index : rods) {
        const std::vector<int>& nodes = model.rods[static_cast<std::size_t>(index)].nodes;
        if (context.names.is_meshed(index) || nodes.empty()) continue;
        for (const int node : {nodes.front(), nodes.back()}) {
            const Node& end = model.nodes[static_cast<std::size_t>(node)];
            for (const int other : rods) {
                if (joined.contains(node) || other == index) continue;
                const std::string place = describe_place_on(
                    model.rods[static_cast<std::size_t>(other)], end.position, tolerance, model);
                if (!place.empty()) return fmt::format("{} lies on {}, within an element", end.name, place);
            }
        }
    }
    return "";
}

std::vector<std::vector<JoinedPoint>> find_coincident_points(const std::vector<int>& rods,
                                                             double tolerance,
                                                             const RodNets& nets,
                                                             const BuildContext& context) {
    std::vector<JoinCandidate> candidates;
    for (const int rod : rods) add_join_candidates(rod, nets, context, candidates);
    std::ranges::stable_sort(candidates, {}, &JoinCandidate::along);
    std::vector<std::vector<JoinedPoint>> groups;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        if (candidates[i].is_grouped) continue;
        const std::vector<JoinCandidate*> group = take_group(candidates, i, tolerance);
        const bool has_point =
            std::ranges::any_of(group, [](const JoinCandidate* one) { return one->is_point; });
        if (group.size() < 2 || !has_point) continue;
        std::vector<JoinedPoint>& joined = groups.emplace_back();
        for (JoinCandidate* one : group) {
            one->is_grouped = true;
            joined.push_back(one->point);
        }
        std::ranges::sort(joined, {}, &JoinedPoint::node);
    }
    std::ranges::sort(groups, {}, [](const auto& group) { return group.front().node; });
    return groups;
}

}  // namespace gxrod
