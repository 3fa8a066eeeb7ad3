#include <fmt/format.h>

#include "deck/places/axes.hpp"
#include "deck/reading/copies.hpp"
#include "deck/sections/section_matrices.hpp"
#include "deck/supports/component_numbers.hpp"
#include "deck/ties/ties.hpp"

namespace gxrod {
namespace {

// Nodes nearer than this, relative to how far they are from the origin, are at one place.
constexpr double same_place = 1e-9;

struct BushingTable : TableHead {
    Ends between;
    std::optional<Vec3> at;
    std::optional<std::variant<Mat3, BushingAxes>> axes;
    std::optional<Mat3> directions;
    std::optional<ComponentNumbers> stiffness, damping;
    std::optional<Mat6> stiffness_matrix, damping_matrix;
    Copies copies;
};

}  // namespace

const TableSpec& bushing_table() {
    using T = BushingTable;
    static const TableSpec stiffness = stiffness_components("bushing.NAME.stiffness");
    static const TableSpec damping = damping_components("bushing.NAME.damping");
    // clang-format off
    static const TableSpec table = Table<T>("[bushing.NAME]",
            "Resists displacements and rotations of B against A in all directions: with stiffness about axes only, a "
            "torsion spring. It is free of force as it is at t = 0.")
        .key("between", &T::between, "What A and B are fixed to: points of rods, bodies, or \"ground\".")
            .required().also("points nodes ends connects")
        .key("at", &T::at, "Where it is at t = 0, global. Rigid arms join it to the nodes.")
            .unit("length").otherwise("where the nodes are, which must be at one place")
            .also("pos position place point location")
        .key("axes", &T::axes, "Its x, y and z directions at t = 0, a row each: of length 1, at right angles, "
             "right-handed (to 1e-6). They turn with A and B, half way between. Or what they turn with: A, B, nothing "
             "(`ground`) or both. A bearing's axes do not turn with the shaft: take the word of what carries the "
             "bearing. Then a rotation that is free of stiffness can be of any size.")
            .unit("1").otherwise("the global axes, `between`").also("frame carrier turns_with")
        .key("directions", &T::directions, "Its x, y and z directions at t = 0, likewise, where `axes` is a word.")
            .unit("1").otherwise("the global axes").only_with("axes").also("orientation triad")
        .key("stiffness", &T::stiffness, stiffness, "Force per displacement and moment per rotation.")
            .also("k rate spring_constant")
        .key("stiffness_matrix", &T::stiffness_matrix,
             "The same as a full matrix, order x y z rx ry rz: symmetric, no energy negative.")
            .unit("of both").also("matrix")
        .key("damping", &T::damping, damping, "Force and moment per rate.")
            .also("c d viscosity kelvin_voigt")
        .key("damping_matrix", &T::damping_matrix, "The same as a full matrix, likewise.")
            .unit("of both")
        .with(add_copies<T>)
        .at_least_one_of({"stiffness", "stiffness_matrix", "damping", "damping_matrix"})
        .at_most_one_of({"stiffness", "stiffness_matrix"})
        .at_most_one_of({"damping", "damping_matrix"})
        .shown_by(
            "[bushing.mount]\n"
            "between   = [\"ground\", \"gyroscope\"]\n"
            "at        = [0, 0, 0]\n"
            "stiffness = { x = 1e3, y = 1e3, z = 4e3, rx = 20, ry = 20 }\n"
            "damping   = { z = 30 }\n"
            "\n"
            "[bushing.bearing]\n"
            "between   = [\"ground\", \"gyroscope\"]\n"
            "at        = [0, 0, 0]\n"
            "axes      = \"ground\"\n"
            "stiffness = { x = 1e4, y = 1e4, z = 1e4, rx = 50, ry = 50 }\n");
    // clang-format on
    return table;
}

namespace {

// The nodes of both ends, -1 for the ground; nullopt if one of them has none.
std::optional<std::array<int, 2>> find_nodes(const BushingTable& given, const BuildContext& context) {
    std::array<int, 2> nodes{-1, -1};
    for (std::size_t i = 0; i < 2; ++i) {
        if (given.between[i].word == ground_word) continue;
        const std::optional<PlacedPoint> point = context.place(given.between[i].word);
        if (!point) return std::nullopt;
        nodes[i] = point->node;
    }
    return nodes;
}

// Where the bushing is: where the deck says, or where its nodes are.
std::optional<Vec3> find_bushing_place(const BushingTable& given,
                                       const std::array<int, 2>& nodes,
                                       const BuildContext& context) {
    if (given.at) return given.at;
    const auto position = [&](std::size_t i) -> const Vec3& {
        return context.model.nodes[static_cast<std::size_t>(nodes[i])].position;
    };
    if (nodes[0] < 0 || nodes[1] < 0) return position(nodes[0] < 0 ? 1 : 0);
    const double apart = (position(1) - position(0)).norm();
    if (apart <= same_place * position(0).norm()) return position(0);
    context.add_fault(
        given,
        given.between,
        fmt::format("the nodes are {:.3g} apart; expected at = [x, y, z], the bushing's place", apart));
    return std::nullopt;
}

// Of the components, or of the full matrix, a field of the table.
Mat6 find_matrix(const BushingTable& given,
                 const std::optional<ComponentNumbers>& components,
                 const std::optional<Mat6>& full,
                 const BuildContext& context) {
    Mat6 matrix = Mat6::Zero();
    if (components) matrix = Vec6(components->values.data()).asDiagonal();
    if (!full) return matrix;
    matrix = *full;
    if (const auto fault = check_semidefinite_matrix(matrix))
        context.faults.add(given.place_of(&full), given.path_of(&full) + fault->entry, fault->message);
    return matrix;
}

std::pair<Quat, BushingAxes> find_bushing_axes(const BushingTable& given, const BuildContext& context) {
    const BushingAxes* word = given.axes ? std::get_if<BushingAxes>(&*given.axes) : nullptr;
    if (word == nullptr && given.directions) {
        context.add_fault(
            given, given.directions, "goes with a word as axes, and axes has directions itself");
        return {Quat::Identity(), BushingAxes::between};
    }
    if (word != nullptr) return {find_axes(given, given.directions, context), *word};
    if (!given.axes) return {Quat::Identity(), BushingAxes::between};
    return {find_axes(given, &given.axes, std::get<Mat3>(*given.axes), context), BushingAxes::between};
}

void build_bushing(const BushingTable& given, BuildContext& context) {
    const auto [axes, carrier] = find_bushing_axes(given, context);
    const Mat6 stiffness = find_matrix(given, given.stiffness, given.stiffness_matrix, context);
    const Mat6 damping = find_matrix(given, given.damping, given.damping_matrix, context);
    const std::optional<std::array<int, 2>> nodes = find_nodes(given, context);
    if (!nodes) return;
    Bushing bushing{
        .name = given.name, .carrier = carrier, .axes = axes, .stiffness = stiffness, .damping = damping};
    for (std::size_t i = 0; i < 2; ++i) bushing.ends[i].node = (*nodes)[i];
    if (!are_apart(given, given.between, bushing.ends, context)) return;
    const std::optional<Vec3> place = find_bushing_place(given, *nodes, context);
    if (!place) return;
    for (Anchor& end : bushing.ends) {
        end.arm = *place;
        if (!end.is_ground()) end.arm -= context.model.nodes[static_cast<std::size_t>(end.node)].position;
    }
    context.model.bushings.push_back(bushing);
}

}  // namespace

void build_bushings(BuildContext& context) {
    for (const BushingTable& given : tables_of<BushingTable>(context.deck, bushing_table()))
        build_bushing(given, context);
}

}  // namespace gxrod
