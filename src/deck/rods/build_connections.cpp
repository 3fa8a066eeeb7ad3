#include "deck/rods/build_connections.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <numeric>
#include <set>

#include "deck/reading/copies.hpp"
#include "deck/schema/schema_tables.hpp"

namespace gxrod {
namespace {

struct ConnectTable : TableHead {
    PointList points;
    Copies copies;
};

}  // namespace

const TableSpec& connect_table() {
    // clang-format off
    static const TableSpec table = Table<ConnectTable>("[[connect]]",
            "Points of rods that become one node, a rigid corner. Rods whose points are at one place are not "
            "connected otherwise.")
        .key("points", &ConnectTable::points, "Two or more, at one place. The node has the name of the first.")
            .required().also("at between nodes ends")
        .with(add_copies<ConnectTable>)
        .shown_by(
            "[rod.tail]\n"
            "section  = \"tube\"\n"
            "line     = { from = [0, 8, 0], to = [0, 8, -4] }\n"
            "elements = 4\n"
            "element  = \"simo\"\n"
            "\n"
            "[[connect]]\n"
            "points = [\"flyer.end\", \"tail.start\"]\n");
    // clang-format on
    return table;
}

namespace {

// Points nearer than this, relative to the model's size, are at one place.
constexpr double same_place = 1e-9;

// Which nodes become one: the one that the deck names first.
class NodeMerge {
  public:
    explicit NodeMerge(std::size_t nodes) : parents_(nodes), ranks_(nodes, never) {
        std::iota(parents_.begin(), parents_.end(), 0);
    }

    void name(int node) {
        if (ranks_[node] == never) ranks_[node] = next_rank_++;
    }

    int root(int node) const {
        while (parents_[node] != node) node = parents_[node];
        return node;
    }

    void join(int first, int second) {
        first = root(first);
        second = root(second);
        if (ranks_[second] < ranks_[first]) std::swap(first, second);
        parents_[second] = first;
    }

    // The new number of every node, those that stand for others keeping their order.
    std::vector<int> renumber() const {
        std::vector<int> numbers(parents_.size());
        int next = 0;
        for (int node = 0; node < static_cast<int>(parents_.size()); ++node) {
            if (parents_[node] == node) numbers[node] = next++;
        }
        for (int node = 0; node < static_cast<int>(parents_.size()); ++node) {
            numbers[node] = numbers[root(node)];
        }
        return numbers;
    }

  private:
    static constexpr int never = std::numeric_limits<int>::max();

    std::vector<int> parents_;
    std::vector<int> ranks_;  // when the deck named the node first
    int next_rank_ = 0;
};

double measure(const Model& model) {
    Eigen::AlignedBox3d box;
    for (const Node& node : model.nodes) box.extend(node.position);
    return box.isEmpty() ? 0.0 : box.diagonal().norm();
}

// The points of a table that have nodes; a fault for those that cannot be connected to the first.
void join_points(const ConnectTable& given, double size, NodeMerge& merge, const BuildContext& context) {
    std::optional<PlacedPoint> first;
    std::string first_name;
    for (const CheckedWord& word : given.points.points) {
        const auto add_fault = [&](const std::string& message) {
            context.faults.add(word.place, word.path, message);
        };
        const std::optional<PlacedPoint> point = context.place(word.word);
        if (!point) continue;
        merge.name(point->node);
        if (!first) {
            first = point;
            first_name = word.word;
            continue;
        }
        const double distance =
            (context.model.nodes[point->node].position - context.model.nodes[first->node].position).norm();
        if (point->node == first->node) {
            add_fault(fmt::format("\"{}\" is the same point as \"{}\"", word.word, first_name));
        } else if (distance > same_place * size) {
            add_fault(
                fmt::format("\"{}\" is {:.6g} away from \"{}\"; points that become one node must be at "
                            "one place, to {:g} of the model's size",
                            word.word,
                            distance,
                            first_name,
                            same_place));
        } else {
            merge.join(first->node, point->node);
        }
    }
}

void remove_repetitions(std::vector<int>& nodes) {
    std::set<int> seen;
    std::erase_if(nodes, [&](int node) { return !seen.insert(node).second; });
}

void apply(const NodeMerge& merge, BuildContext& context) {
    const std::vector<int> numbers = merge.renumber();
    const auto renumber = [&](std::vector<int>& nodes) {
        for (int& node : nodes) node = numbers[node];
    };
    std::vector<Node> kept;
    for (int node = 0; node < static_cast<int>(numbers.size()); ++node) {
        if (merge.root(node) == node) kept.push_back(std::move(context.model.nodes[node]));
    }
    context.model.nodes = std::move(kept);
    for (std::size_t i = 0; i < context.model.rods.size(); ++i) {
        Rod& rod = context.model.rods[i];
        renumber(rod.element_nodes);
        renumber(rod.nodes);
        remove_repetitions(rod.nodes);
        renumber(context.rod_nodes[i]);
    }
}

// A node of the rod that occurs twice in one of its elements; -1 if there is none.
int find_repeated_node(const Rod& rod) {
    const auto size = static_cast<std::ptrdiff_t>(rod.order) + 1;
    for (auto element = rod.element_nodes.begin(); element != rod.element_nodes.end(); element += size) {
        for (auto node = element; node != element + size; ++node) {
            if (std::count(element, element + size, *node) > 1) return *node;
        }
    }
    return -1;
}

bool names(const ConnectTable& given, int node, const BuildContext& context) {
    return std::ranges::any_of(given.points.points, [&](const CheckedWord& word) {
        const std::optional<PlacedPoint> point = context.place(word.word);
        return point && point->node == node;
    });
}

// An element needs all of its nodes.
void check_elements(const BuildContext& context) {
    const auto tables = tables_of<ConnectTable>(context.deck, connect_table());
    for (const Rod& rod : context.model.rods) {
        const int node = find_repeated_node(rod);
        if (node < 0) continue;
        const ConnectTable& given =
            *std::find_if(tables.rbegin(), tables.rend(), [&](const ConnectTable& candidate) {
                return names(candidate, node, context);
            });
        context.add_fault(given,
                          given.points,
                          fmt::format("both ends of an element of rod.{} become one node; give the rod two "
                                      "elements at least between them",
                                      rod.name));
    }
}

}  // namespace

void build_connections(BuildContext& context) {
    for (const Rod& rod : context.model.rods) context.rod_nodes.push_back(rod.nodes);
    const auto tables = tables_of<ConnectTable>(context.deck, connect_table());
    if (tables.empty()) return;
    NodeMerge merge(context.model.nodes.size());
    const double size = measure(context.model);
    for (const ConnectTable& given : tables) join_points(given, size, merge, context);
    apply(merge, context);
    check_elements(context);
}

}  // namespace gxrod
