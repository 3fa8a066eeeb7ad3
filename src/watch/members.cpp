#include "watch/members.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "model/ties/ties.hpp"

namespace gxrod {
namespace {

// A bend between elements beyond which there is a corner; smooth lines cut into straight elements have
// less.
constexpr double least_corner = 5.0 * std::numbers::pi / 180.0;

// Nodes at which members end: with something else than two elements of one rod, or a point of the deck.
std::vector<bool> find_member_ends(const Model& model) {
    std::vector<int> elements(model.nodes.size(), 0);
    for (const Rod& rod : model.rods) {
        const auto per_element = static_cast<std::size_t>(rod.order) + 1;
        for (std::size_t first = 0; first < rod.element_nodes.size(); first += per_element) {
            ++elements[static_cast<std::size_t>(rod.element_nodes[first])];
            ++elements[static_cast<std::size_t>(rod.element_nodes[first + per_element - 1])];
        }
    }
    std::vector<bool> is_end(model.nodes.size());
    for (std::size_t node = 0; node < is_end.size(); ++node) {
        const bool is_numbered = model.nodes[node].name.find(" node ") != std::string::npos;
        is_end[node] = elements[node] != 2 || !is_numbered;
    }
    for (const Support& support : model.supports) is_end[static_cast<std::size_t>(support.node)] = true;
    for (const Body& body : model.bodies) is_end[static_cast<std::size_t>(body.node)] = true;
    for_each_anchor(model, [&](const Anchor& anchor) {
        if (!anchor.is_ground()) is_end[static_cast<std::size_t>(anchor.node)] = true;
    });
    return is_end;
}

bool has_corner_between(const Quat& before, const Quat& after) {
    const Vec3 a = before * Vec3::UnitX(), b = after * Vec3::UnitX();
    return std::atan2(a.cross(b).norm(), a.dot(b)) > least_corner;
}

void add_members_of_rod(const Model& model,
                        int index,
                        const std::vector<bool>& is_end,
                        std::vector<Member>& all) {
    const Rod& rod = model.rods[static_cast<std::size_t>(index)];
    const auto per_element = static_cast<std::size_t>(rod.order) + 1;
    const std::size_t first_member = all.size();
    for (int e = 0; e < rod.element_count(); ++e) {
        const std::size_t first = static_cast<std::size_t>(e) * per_element;
        const int node = rod.element_nodes[first];
        const bool is_new = e == 0 || rod.element_nodes[first - 1] != node ||
                            is_end[static_cast<std::size_t>(node)] ||
                            has_corner_between(rod.triads[first - 1], rod.triads[first]);
        if (is_new) {
            all.push_back({.name = rod.name});
            all.back().ends[0] = {index, e, -1.0};
            all.back().nodes[0] = node;
        }
        all.back().ends[1] = {index, e, 1.0};
        all.back().nodes[1] = rod.element_nodes[first + per_element - 1];
    }
    if (all.size() == first_member + 1) return;
    for (std::size_t i = first_member; i < all.size(); ++i)
        all[i].name += fmt::format("/{}", i - first_member + 1);
}

}  // namespace

std::vector<Member> list_members(const Model& model) {
    const std::vector<bool> is_end = find_member_ends(model);
    std::vector<Member> members;
    for (std::size_t i = 0; i < model.rods.size(); ++i)
        add_members_of_rod(model, static_cast<int>(i), is_end, members);
    return members;
}

}  // namespace gxrod
