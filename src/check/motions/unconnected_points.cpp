#include "check/motions/unconnected_points.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <set>

#include "model/ties/ties.hpp"

namespace gxrod {
namespace {

// Nodes nearer than this, relative to the length of the shorter of their rods, look like one place.
constexpr double same_place = 1e-6;
// Up to this, relative to the model's size, [[connect]] takes them.
constexpr double connectable = 1e-9;
// Of the coordinates: nearer nodes are at one place however short their rods are.
constexpr double round_off = 1e-14;

// Nodes at which one element of a rod begins or ends, and no other one.
std::vector<int> find_ends(const Model& model) {
    std::vector<int> count(model.nodes.size(), 0);
    for (const Rod& rod : model.rods) {
        const auto size = static_cast<std::size_t>(rod.order) + 1;
        for (std::size_t first = 0; first < rod.element_nodes.size(); first += size) {
            ++count[rod.element_nodes[first]];
            ++count[rod.element_nodes[first + size - 1]];
        }
    }
    std::vector<int> ends;
    for (int node = 0; node < static_cast<int>(count.size()); ++node) {
        if (count[node] == 1) ends.push_back(node);
    }
    return ends;
}

// Where a node is in a rod.
struct RodStation {
    int rod = -1;
    double s = 0.0;
};

// Each node's stations; several in corners, where rods meet, and where a rod closes.
std::vector<std::vector<RodStation>> find_stations(const Model& model) {
    std::vector<std::vector<RodStation>> stations(model.nodes.size());
    for (int r = 0; r < static_cast<int>(model.rods.size()); ++r) {
        const Rod& rod = model.rods[r];
        for (std::size_t i = 0; i < rod.element_nodes.size(); ++i) {
            stations[rod.element_nodes[i]].push_back({r, rod.arc_length[i]});
        }
    }
    return stations;
}

// The ends of rods by their places, for a search that does not compare all with all.
class EndSearch {
  public:
    EndSearch(const Model& model, double size)
        : model_(model), stations_(find_stations(model)), tolerances_(model.nodes.size(), same_place * size) {
        for (std::size_t node = 0; node < stations_.size(); ++node) {
            for (const RodStation& station : stations_[node]) {
                const double length = model.rods[station.rod].length;
                tolerances_[node] = std::min(tolerances_[node], same_place * length + round_off * size);
            }
        }
        for (const int end : find_ends(model)) keys_.emplace_back(key(end), end);
        std::sort(keys_.begin(), keys_.end());
    }

    // The ends, other than the node itself, that are where the node is.
    std::vector<int> find(int node) const {
        std::vector<int> found;
        const double at = key(node);
        const double most = tolerances_[node];
        auto candidate = std::lower_bound(keys_.begin(), keys_.end(), std::pair(at - most, -1));
        for (; candidate != keys_.end() && candidate->first <= at + most; ++candidate) {
            const int end = candidate->second;
            const double distance = (model_.nodes[end].position - model_.nodes[node].position).norm();
            const double tolerance = std::min(most, tolerances_[end]);
            if (end != node && distance <= tolerance && !are_neighbours(node, end, distance)) {
                found.push_back(end);
            }
        }
        return found;
    }

  private:
    // Whether a rod leads straight from one node to the other.
    bool are_neighbours(int first, int second, double distance) const {
        constexpr double straight = 2.0;
        for (const RodStation& a : stations_[first]) {
            for (const RodStation& b : stations_[second]) {
                if (a.rod == b.rod && std::abs(a.s - b.s) <= straight * distance) return true;
            }
        }
        return false;
    }

    // The coordinate along a direction that decks do not use.
    double key(int node) const { return Vec3(0.5377, 0.6181, 0.5735).dot(model_.nodes[node].position); }

    const Model& model_;
    std::vector<std::vector<RodStation>> stations_;
    std::vector<double> tolerances_;  // of each node, by the shortest of its rods
    std::vector<std::pair<double, int>> keys_;
};

bool is_wholly_held(const Model& model, int node) {
    return std::any_of(model.supports.begin(), model.supports.end(), [&](const Support& support) {
        return support.node == node && support.holds_all(0) && support.holds_all(3);
    });
}

// What a deck calls the node: "leg.end", "leg@0.25", the name of a body.
std::string name_point(const Model& model, int node) {
    for (const Rod& rod : model.rods) {
        const auto found = std::find(rod.nodes.begin(), rod.nodes.end(), node);
        if (found == rod.nodes.end()) continue;
        const std::string& name = model.nodes[node].name;
        if (name != fmt::format("{} node {}", rod.name, found - rod.nodes.begin())) return name;
        const auto entry = std::find(rod.element_nodes.begin(), rod.element_nodes.end(), node);
        const double s = rod.arc_length[static_cast<std::size_t>(entry - rod.element_nodes.begin())];
        return fmt::format("{}@{:.9g}", rod.name, s / rod.length);
    }
    for (const Body& body : model.bodies) {
        if (body.node == node) return body.name;
    }
    return model.nodes[node].name;
}

bool is_of_rod(const Model& model, int node) {
    return std::any_of(model.rods.begin(), model.rods.end(), [node](const Rod& rod) {
        return std::find(rod.nodes.begin(), rod.nodes.end(), node) != rod.nodes.end();
    });
}

// `nodes` are at one place, the first of them on a rod.
std::string describe(const Model& model, const std::set<int>& nodes, double size) {
    std::vector<std::string> points, bodies;
    int first = -1;
    double gap = 0.0;
    for (const int node : nodes) {
        if (first < 0) first = node;
        gap = std::max(gap, (model.nodes[node].position - model.nodes[first].position).norm());
        (is_of_rod(model, node) ? points : bodies).push_back(name_point(model, node));
    }
    std::vector<std::string> all = points;
    all.insert(all.end(), bodies.begin(), bodies.end());
    std::string text = fmt::format("{} are ", fmt::join(all, " and "));
    text += gap > connectable * size ? fmt::format("only {:.3g} apart", gap) : "at one place";
    text += " and not connected";
    if (gap > connectable * size) return text + "; points that are to be one must agree better";
    if (points.size() > 1) {
        text +=
            fmt::format("; to connect them write [[connect]] points = [\"{}\"]", fmt::join(points, "\", \""));
    }
    for (const std::string& body : bodies) {
        text += fmt::format("; to fix body.{} there write at = \"{}\"", body, points.front());
    }
    return text;
}

}  // namespace

namespace {

// Pairs of nodes, the lower one first.
using TiedNodes = std::set<std::pair<int, int>>;

TiedNodes find_tied_nodes(const Model& model) {
    TiedNodes nodes;
    for (const Tie& tie : list_ties(model)) nodes.insert(std::minmax(tie.ends[0].node, tie.ends[1].node));
    return nodes;
}

bool has_tie(const std::set<int>& nodes, const TiedNodes& ties) {
    for (auto one = nodes.begin(); one != nodes.end(); ++one) {
        for (auto other = std::next(one); other != nodes.end(); ++other) {
            if (ties.contains({*one, *other})) return true;
        }
    }
    return false;
}

}  // namespace

std::vector<std::string> find_unconnected_points(const Model& model) {
    const TiedNodes ties = find_tied_nodes(model);
    Eigen::AlignedBox3d box;
    for (const Node& node : model.nodes) box.extend(node.position);
    const double size = box.isEmpty() ? 0.0 : box.diagonal().norm();
    const EndSearch search(model, size);
    // Places by the first of the ends that are there.
    std::map<int, std::set<int>> places;
    for (int node = 0; node < static_cast<int>(model.nodes.size()); ++node) {
        const std::vector<int> ends = search.find(node);
        if (ends.empty()) continue;
        const int first = *std::min_element(ends.begin(), ends.end());
        const std::vector<int> around = search.find(first);
        const int key =
            around.empty() ? first : std::min(first, *std::min_element(around.begin(), around.end()));
        std::set<int>& place = places[key];
        place.insert(node);
        place.insert(ends.begin(), ends.end());
    }
    std::vector<std::string> sentences;
    for (const auto& [first, nodes] : places) {
        const bool all_held =
            std::all_of(nodes.begin(), nodes.end(), [&](int node) { return is_wholly_held(model, node); });
        if (!all_held && !has_tie(nodes, ties)) sentences.push_back(describe(model, nodes, size));
    }
    return sentences;
}

}  // namespace gxrod
