#include "deck/ties/build_bushings.hpp"

#include <fmt/format.h>

#include "deck/joints/ends.hpp"
#include "deck/places/axes.hpp"
#include "deck/schema/choices.hpp"
#include "deck/sections/section_matrices.hpp"
#include "deck/ties/build_springs.hpp"

namespace gxrod {
namespace {

// Nodes nearer than this, relative to how far they are from the origin, are at one place.
constexpr double same_place = 1e-9;

// The nodes of both ends, -1 for the ground; nullopt if one of them has none.
std::optional<std::array<int, 2>> find_nodes(const CheckedTable& table, const BuildContext& context) {
    std::array<int, 2> nodes{-1, -1};
    const auto& words = ends_of(table);
    for (std::size_t i = 0; i < 2; ++i) {
        if (words[i].word == ground_word) continue;
        const std::optional<PlacedPoint> point = context.place(words[i].word);
        if (!point) return std::nullopt;
        nodes[i] = point->node;
    }
    return nodes;
}

// Where the bushing is: where the deck says, or where its nodes are.
std::optional<Vec3> find_bushing_place(const CheckedTable& table,
                                       const std::array<int, 2>& nodes,
                                       const BuildContext& context) {
    if (table.gives("at")) return table.get<Vec3>("at");
    const auto position = [&](std::size_t i) -> const Vec3& {
        return context.model.nodes[static_cast<std::size_t>(nodes[i])].position;
    };
    if (nodes[0] < 0 || nodes[1] < 0) return position(nodes[0] < 0 ? 1 : 0);
    const double apart = (position(1) - position(0)).norm();
    if (apart <= same_place * position(0).norm()) return position(0);
    context.add_fault(
        table,
        "between",
        fmt::format("the nodes are {:.3g} apart; expected at = [x, y, z], the bushing's place", apart));
    return std::nullopt;
}

Mat6 find_matrix(const CheckedTable& table, const std::string& key, const BuildContext& context) {
    Mat6 matrix = Mat6::Zero();
    if (table.gives(key)) {
        const CheckedTable& components = table.tables(key).front();
        for (int i = 0; i < 6; ++i) matrix(i, i) = components.get<double>(component_names[i]);
    }
    const std::string full = key + "_matrix";
    if (!table.gives(full)) return matrix;
    matrix = table.get<Mat6>(full);
    if (const auto fault = check_semidefinite_matrix(matrix))
        context.faults.add(table.place_of(full), table.path_of(full) + fault->entry, fault->message);
    return matrix;
}

std::pair<Quat, BushingAxes> find_bushing_axes(const CheckedTable& table, const BuildContext& context) {
    const bool is_word =
        table.gives("axes") && std::holds_alternative<std::string>(table.find("axes")->value);
    if (!is_word && table.gives("directions")) {
        context.add_fault(table, "directions", "goes with a word as axes, and axes has directions itself");
        return {Quat::Identity(), BushingAxes::between};
    }
    if (!is_word) return {find_axes(table, context), BushingAxes::between};
    return {find_axes(table, context, "directions"),
            value_of(bushing_axes_choices, table.get<std::string>("axes"))};
}

void build_bushing(const CheckedTable& table, BuildContext& context) {
    const auto [axes, carrier] = find_bushing_axes(table, context);
    const Mat6 stiffness = find_matrix(table, "stiffness", context);
    const Mat6 damping = find_matrix(table, "damping", context);
    const std::optional<std::array<int, 2>> nodes = find_nodes(table, context);
    if (!nodes) return;
    Bushing bushing{
        .name = table.name, .carrier = carrier, .axes = axes, .stiffness = stiffness, .damping = damping};
    for (std::size_t i = 0; i < 2; ++i) bushing.ends[i].node = (*nodes)[i];
    if (!are_apart(table, bushing.ends, context)) return;
    const std::optional<Vec3> place = find_bushing_place(table, *nodes, context);
    if (!place) return;
    for (Anchor& end : bushing.ends) {
        end.arm = *place;
        if (!end.is_ground()) end.arm -= context.model.nodes[static_cast<std::size_t>(end.node)].position;
    }
    context.model.bushings.push_back(bushing);
}

}  // namespace

void build_bushings(BuildContext& context) {
    for (const CheckedTable& table : context.deck.tables("bushing")) build_bushing(table, context);
}

}  // namespace gxrod
