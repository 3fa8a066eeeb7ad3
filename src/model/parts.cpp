#include "model/parts.hpp"

#include <algorithm>

#include "model/ties/ties.hpp"
#include "numerics/disjoint_sets.hpp"

namespace gxrod {

namespace {

void join_rod(const Rod& rod, DisjointSets& sets) {
    const int stride = rod.order + 1;
    for (int e = 0; e < rod.element_count(); ++e) {
        for (int i = 1; i < stride; ++i) {
            sets.join(rod.element_nodes[e * stride], rod.element_nodes[e * stride + i]);
        }
    }
}

void add_once(std::vector<int>& list, int index) {
    if (list.empty() || list.back() != index) list.push_back(index);
}

// "rod a", "rods a, b and c"; of many the first ones.
std::string list_names(const char* one, const char* several, const std::vector<std::string>& names) {
    constexpr std::size_t most = 6;
    std::string text = (names.size() == 1 ? one : several) + (" " + names[0]);
    const std::size_t listed = std::min(names.size(), most);
    for (std::size_t i = 1; i < listed; ++i) text += (i + 1 == names.size() ? " and " : ", ") + names[i];
    return listed == names.size() ? text : text + " and " + std::to_string(names.size() - listed) + " more";
}

DisjointSets tie_nodes(const Model& model, Ties ties) {
    DisjointSets sets(model.nodes.size());
    for (const Rod& rod : model.rods) join_rod(rod, sets);
    if (ties == Ties::rods) return sets;
    for (const Tie& tie : list_ties(model)) {
        if (!tie.has_ground()) sets.join(tie.ends[0].node, tie.ends[1].node);
    }
    return sets;
}

}  // namespace

std::vector<ModelPart> find_parts(const Model& model, Ties ties) {
    DisjointSets sets = tie_nodes(model, ties);
    std::vector<ModelPart> parts;
    std::vector<int> part_of(model.nodes.size(), -1);
    for (int node = 0; node < static_cast<int>(model.nodes.size()); ++node) {
        const int first = sets.find(node);
        if (first == node) {
            part_of[node] = static_cast<int>(parts.size());
            parts.emplace_back();
        } else {
            part_of[node] = part_of[first];
        }
        parts[part_of[node]].nodes.push_back(node);
    }
    for (int rod = 0; rod < static_cast<int>(model.rods.size()); ++rod) {
        for (const int node : model.rods[rod].element_nodes) add_once(parts[part_of[node]].rods, rod);
    }
    for (int body = 0; body < static_cast<int>(model.bodies.size()); ++body) {
        parts[part_of[model.bodies[body].node]].bodies.push_back(body);
    }
    for (const Tie& tie : list_ties(model)) {
        for (const Anchor& end : tie.ends) {
            if (end.is_ground()) continue;
            add_once(parts[part_of[end.node]].ties_by_kind[static_cast<std::size_t>(tie.kind)],
                     static_cast<int>(tie.index));
        }
    }
    return parts;
}

bool is_joined_to_ground(const Model& model) {
    return std::ranges::any_of(model.joints, &Joint::has_ground) ||
           std::ranges::any_of(model.sleeves, [](const Sleeve& sleeve) { return sleeve.point.is_ground(); });
}

bool is_held(const Model& model) { return !model.supports.empty() || is_joined_to_ground(model); }

std::string name_part(const ModelPart& part, const Model& model) {
    std::vector<std::string> rods, bodies;
    for (const int rod : part.rods) rods.push_back(model.rods[rod].name);
    for (const int body : part.bodies) bodies.push_back(model.bodies[body].name);
    if (rods.empty() && bodies.empty()) return model.nodes[part.nodes.front()].name;
    std::string text = rods.empty() ? "" : list_names("rod", "rods", rods);
    if (!bodies.empty()) text += (rods.empty() ? "" : ", ") + list_names("body", "bodies", bodies);
    return rods.size() + bodies.size() == 1 ? text : "the part with " + text;
}

}  // namespace gxrod
