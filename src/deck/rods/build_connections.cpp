#include "deck/rods/build_connections.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <set>

#include "deck/places/part.hpp"
#include "deck/reading/copies.hpp"
#include "deck/rods/coincident_points.hpp"
#include "deck/rods/node_merge.hpp"
#include "deck/rods/rod_table.hpp"
#include "deck/schema/schema_tables.hpp"
#include "deck/table/place_kinds.hpp"

namespace gxrod {
namespace {

struct ConnectTable : TableHead {
    ConnectedPoints points;
    std::optional<TableNames> on;
    std::optional<double> tolerance;
    Copies copies;
};

}  // namespace

const TableSpec& connect_table() {
    using T = ConnectTable;
    // clang-format off
    static const TableSpec table = Table<T>("[[connect]]",
            "Points of rods that become one node, a rigid corner. Rods whose points are at one place are not "
            "connected otherwise. Ends that `hinges` of a rod names are tied by a hinge.")
        .key("points", &T::points, "Two or more, at one place. The node has the name of the first. Or \"coincident\": "
             "wherever an end or corner of a rod, a point that the deck names or the end of a curve of a mesh's geometry is "
             "at the place of such a node, or of another node between elements.")
            .required().also("at between nodes ends")
        .key("on", &T::on, "With coincident points: the rods whose points are connected.")
            .names_of({"rod"}).otherwise("all rods").also("rods")
        .key("tolerance", &T::tolerance, "How far points at one place are apart at most.")
            .unit("length").at_least(0).otherwise("1e-9 of the size of the model; of coincident points 1e-6")
            .also("tol distance")
        .with(add_copies<T>)
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
constexpr double coincident_place = 1e-6;

double measure(const Model& model) {
    Eigen::AlignedBox3d box;
    for (const Node& node : model.nodes) box.extend(node.position);
    return box.isEmpty() ? 0.0 : box.diagonal().norm();
}

// Why two points cannot be one node; "" if they can.
std::string explain_apart(const JoinedPoint& first,
                          const JoinedPoint& second,
                          const std::optional<double>& tolerance,
                          const Model& model) {
    if (second.node == first.node)
        return fmt::format("\"{}\" is the same point as \"{}\"", second.name, first.name);
    const double distance = (model.nodes[second.node].position - model.nodes[first.node].position).norm();
    if (distance <= tolerance.value_or(same_place * measure(model))) return "";
    return fmt::format(
        "\"{}\" is {:.6g} away from \"{}\"; points that become one node must be at one place, to {}",
        second.name,
        distance,
        first.name,
        tolerance ? fmt::format("the tolerance of {:g}", *tolerance)
                  : fmt::format("{:g} of the model's size", same_place));
}

// The points of a table that are to be one node; a fault of each that is not where the first is.
std::vector<JoinedPoint> list_joined(const ConnectTable& given, const BuildContext& context) {
    std::vector<JoinedPoint> joined;
    for (const CheckedWord& word : given.points.words) {
        const auto found = context.names.find_all(word.word);
        const auto* points = std::get_if<std::vector<NamedPoint>>(&found);
        if (points == nullptr) continue;
        for (const NamedPoint& one : *points) {
            const std::optional<PlacedPoint> placed = context.place(one.point);
            if (!placed || placed->body >= 0) continue;
            const JoinedPoint point = make_joined(one.text, *placed, context);
            const std::string reason =
                joined.empty() ? "" : explain_apart(joined.front(), point, given.tolerance, context.model);
            if (!reason.empty()) context.faults.add(word.place, word.path, reason);
            if (reason.empty()) joined.push_back(point);
        }
    }
    if (joined.size() == 1 && given.points.words.size() == 1)
        context.add_fault(
            given,
            given.points,
            fmt::format("matches \"{}\" alone; expected two points or more", joined.front().name));
    return joined;
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
    // Nodes of a mesh where all its members have hinges.
    for (const MemberHinge& hinge : context.hinges) {
        Rod& rod = context.model.rods[static_cast<std::size_t>(hinge.rod)];
        std::erase_if(rod.nodes, [&](int node) {
            return std::ranges::find(rod.element_nodes, node) == rod.element_nodes.end();
        });
    }
    for (MemberHinge& hinge : context.hinges) {
        hinge.node = numbers[hinge.node];
        hinge.own_node = numbers[hinge.own_node];
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

// An element needs all of its nodes.
void check_elements(const BuildContext& context) {
    const ConnectTable& last = tables_of<ConnectTable>(context.deck, connect_table()).back();
    for (const Rod& rod : context.model.rods) {
        if (find_repeated_node(rod) < 0) continue;
        context.add_fault(last,
                          last.points,
                          fmt::format("both ends of an element of rod.{} become one node; give the rod two "
                                      "elements at least between them",
                                      rod.name));
    }
}

// The groups of points that a table makes one node each.
std::vector<std::vector<JoinedPoint>> list_groups(const ConnectTable& given,
                                                  double size,
                                                  const RodNets& nets,
                                                  BuildContext& context) {
    if (!given.points.are_coincident()) {
        if (given.on) context.add_fault(given, given.on, "goes with points = \"coincident\"");
        return {list_joined(given, context)};
    }
    std::vector<int> rods = context.names.find_rods("*");
    if (given.on) {
        rods.clear();
        for (const Part& part : find_parts(given, *given.on, context)) rods.push_back(part.rod);
    }
    const double tolerance = given.tolerance.value_or(coincident_place * size);
    auto groups = find_coincident_points(rods, tolerance, nets, context);
    const std::string loose = explain_loose_end(rods, tolerance, groups, context);
    if (!loose.empty()) {
        context.add_fault(given,
                          given.points,
                          loose +
                              "; a point ROD@FRACTION in a [[connect]] of both gives it a node "
                              "there, as other numbers of elements can");
    } else if (groups.empty() && context.faults.empty()) {  // rods at fault have no points
        context.add_fault(given,
                          given.points,
                          "no points coincide; a larger tolerance finds points that are near to each other");
    }
    return groups;
}

// Makes one node of a group; ends with a hinge keep theirs.
void join_group(const std::vector<JoinedPoint>& group, NodeMerge& merge, BuildContext& context) {
    if (group.empty()) return;
    const auto held = std::ranges::find(group, false, &JoinedPoint::is_hinged);
    const JoinedPoint& main = held == group.end() ? group.front() : *held;
    for (const JoinedPoint& one : group) merge.name(one.node);
    for (const JoinedPoint& one : group) {
        if (&one == &main) continue;
        const auto known = std::ranges::find(context.hinges, one.node, &MemberHinge::own_node);
        if (!one.is_hinged)
            merge.join(main.node, one.node);
        else if (known != context.hinges.end())  // another table has tied it, to what is the same place then
            merge.join(known->node, main.node);
        else
            context.hinges.push_back({one.name, main.name, main.node, one.node, one.rod});
    }
}

// Ends with a hinge that nothing holds.
void check_hinges(const BuildContext& context) {
    for (const RodTable& table : rods_of(context.deck)) {
        if (!table.hinges || table.mesh) continue;
        for (const CheckedWord& word : table.hinges->words) {
            const std::string name = table.name + "." + word.word;
            const auto is_used = [&](const MemberHinge& hinge) {
                return hinge.name == name || hinge.first_name == name;
            };
            if (std::ranges::any_of(context.hinges, is_used)) continue;
            context.faults.add(
                word.place,
                word.path,
                fmt::format(
                    "no [[connect]] ties {} to another point; at a [[support]] a hinge is what leaves "
                    "the rotations free",
                    name));
        }
    }
}

// Where members of meshes have hinges alone, one of them keeps the node, whose rotation nothing else would
// hold.
void hold_free_nodes(NodeMerge& merge, BuildContext& context) {
    if (context.hinges.empty()) return;
    std::set<int> used;
    for (const Rod& rod : context.model.rods) {
        for (const int node : rod.element_nodes) used.insert(merge.root(node));
    }
    std::erase_if(context.hinges, [&](const MemberHinge& hinge) {
        if (!used.insert(merge.root(hinge.node)).second) return false;
        merge.join(hinge.node, hinge.own_node);
        return true;
    });
}

}  // namespace

void build_connections(const RodNets& nets, BuildContext& context) {
    for (const Rod& rod : context.model.rods) context.rod_nodes.push_back(rod.nodes);
    const auto tables = tables_of<ConnectTable>(context.deck, connect_table());
    NodeMerge merge(context.model.nodes.size());
    const double size = measure(context.model);
    for (const ConnectTable& given : tables) {
        for (const auto& group : list_groups(given, size, nets, context)) join_group(group, merge, context);
    }
    check_hinges(context);
    hold_free_nodes(merge, context);
    if (tables.empty() && context.hinges.empty()) return;
    apply(merge, context);
    if (!tables.empty()) check_elements(context);
}

}  // namespace gxrod
