#include "analyses/connected_parts.hpp"

#include <fmt/format.h>

#include <numeric>

namespace gxrod {
namespace {

// Which of the nodes before it a node hangs on; itself if on none.
class NodeGroups {
  public:
    explicit NodeGroups(std::size_t nodes) : parents_(nodes) {
        std::iota(parents_.begin(), parents_.end(), 0);
    }

    int root(int node) {
        while (parents_[node] != node) {
            parents_[node] = parents_[parents_[node]];
            node = parents_[node];
        }
        return node;
    }

    void join(int first, int second) {
        const int a = root(first);
        const int b = root(second);
        parents_[std::max(a, b)] = std::min(a, b);
    }

  private:
    std::vector<int> parents_;
};

// "rod a", "rods a, b and c"; of many the first ones.
std::string list_names(const char* kind, const std::vector<std::string>& names) {
    constexpr std::size_t most = 6;
    if (names.size() == 1) return fmt::format("{} {}", kind, names[0]);
    const std::size_t listed = std::min(names.size(), most);
    std::string text = fmt::format("{}s {}", kind, names[0]);
    for (std::size_t i = 1; i < listed; ++i) {
        text += (i + 1 == names.size() ? " and " : ", ") + names[i];
    }
    if (listed < names.size()) text += fmt::format(" and {} more", names.size() - listed);
    return text;
}

}  // namespace

std::vector<ConnectedPart> find_connected_parts(const Model& model) {
    NodeGroups groups(model.nodes.size());
    for (const Rod& rod : model.rods) {
        for (std::size_t i = 1; i < rod.element_nodes.size(); ++i) {
            const bool starts_element = i % (static_cast<std::size_t>(rod.order) + 1) == 0;
            if (!starts_element) groups.join(rod.element_nodes[i - 1], rod.element_nodes[i]);
        }
    }
    std::vector<ConnectedPart> parts;
    std::vector<int> part_of_root(model.nodes.size(), -1);
    for (int node = 0; node < static_cast<int>(model.nodes.size()); ++node) {
        int& part = part_of_root[groups.root(node)];
        if (part < 0) {
            part = static_cast<int>(parts.size());
            parts.emplace_back();
        }
        parts[part].nodes.push_back(node);
    }
    const auto add = [&](int node, std::vector<int> ConnectedPart::*members, int index) {
        std::vector<int>& list = parts[part_of_root[groups.root(node)]].*members;
        if (list.empty() || list.back() != index) list.push_back(index);
    };
    for (int i = 0; i < static_cast<int>(model.rods.size()); ++i) {
        for (const int node : model.rods[i].nodes) add(node, &ConnectedPart::rods, i);
    }
    for (int i = 0; i < static_cast<int>(model.bodies.size()); ++i) {
        add(model.bodies[i].node, &ConnectedPart::bodies, i);
    }
    return parts;
}

std::string describe_part(const Model& model, const ConnectedPart& part) {
    std::vector<std::string> rods, bodies;
    for (const int rod : part.rods) rods.push_back(model.rods[rod].name);
    for (const int body : part.bodies) bodies.push_back(model.bodies[body].name);
    if (rods.empty()) return bodies.empty() ? "" : list_names(bodies.size() == 1 ? "body" : "bodie", bodies);
    std::string text = list_names("rod", rods);
    if (!bodies.empty()) text += ", " + list_names(bodies.size() == 1 ? "body" : "bodie", bodies);
    return text;
}

}  // namespace gxrod
