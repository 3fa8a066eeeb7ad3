#include "model/parts.hpp"

#include <algorithm>
#include <numeric>

namespace gxrod {

namespace {

// Disjoint sets of nodes, each known by its first one.
class NodeSets {
  public:
    explicit NodeSets(std::size_t node_count) : parents_(node_count) {
        std::iota(parents_.begin(), parents_.end(), 0);
    }
    int find(int node) {
        while (parents_[node] != node) node = parents_[node] = parents_[parents_[node]];
        return node;
    }
    void join(int a, int b) {
        const auto [first, second] = std::minmax({find(a), find(b)});
        parents_[second] = first;
    }

  private:
    std::vector<int> parents_;
};

void join_rod(const Rod& rod, NodeSets& sets) {
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

}  // namespace

std::vector<ModelPart> find_parts(const Model& model) {
    NodeSets sets(model.nodes.size());
    for (const Rod& rod : model.rods) join_rod(rod, sets);
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
    return parts;
}

std::string name_part(const ModelPart& part, const Model& model) {
    if (part.rods.empty()) {
        return part.bodies.empty() ? model.nodes[part.nodes.front()].name
                                   : "body " + model.bodies[part.bodies.front()].name;
    }
    const std::string& first = model.rods[part.rods.front()].name;
    const std::size_t count = part.rods.size();
    if (count == 1) return "rod " + first;
    if (count == 2) return "the part with rods " + first + " and " + model.rods[part.rods[1]].name;
    return "the part with rod " + first + " and " + std::to_string(count - 1) + " others";
}

}  // namespace gxrod
