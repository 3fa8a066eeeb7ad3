#include <fmt/format.h>

#include <algorithm>

#include "deck/checks/check_moves.hpp"
#include "deck/joints/ends.hpp"
#include "deck/loads/acting.hpp"
#include "deck/places/axes.hpp"
#include "deck/places/plane.hpp"
#include "deck/places/point_patterns.hpp"
#include "deck/schema/schema_tables.hpp"
#include "deck/schema/suggestion.hpp"
#include "deck/supports/build_supports.hpp"
#include "deck/supports/components.hpp"
#include "deck/supports/support_merge.hpp"
#include "model/ties/yielding_supports.hpp"

namespace gxrod {
const TableSpec& support_table() {
    using T = SupportTable;
    static const TableSpec move = with_components(Table<MoveTable>("support.move", ""));
    static const TableSpec stiffness = stiffness_components("support.stiffness");
    static const TableSpec damping = damping_components("support.damping");
    // clang-format off
    static const TableSpec table = Table<T>("[[support]]",
            "Components of a point that are fixed, move as prescribed or yield. Of the rotations none, all three or "
            "exactly two fixed: a hinge about the third axis. Supports of one point add up.")
        .key("at", &T::at, "A point of a rod, or a body, or several; with `where`, rods too.")
            .also("pos position point node location")
        .key("where", &T::where, "At which of these points, as they are at t = 0; s is the arc length from the rod's "
             "start. Comparisons allow for round-off. Without `at`, at ends and corners of rods and nodes between "
             "elements of meshes.")
            .otherwise("all").also("if filter region box condition")
        .key("fix", &T::fix, "position is x y z, rotation is rx ry rz, all is both.")
            .words(component_words()).also("type fixed dof dofs constrain constrained restrain components clamped")
        .key("move", &T::move, move, "Prescribed motion. Where a rotation is moved, the other two are fixed or moved "
             "too, and exp of the vector (rx, ry, rz), of any size, is the rotation since t = 0. In a dynamic "
             "analysis 0 at t = 0.")
            .also("displacement motion prescribed prescribed_displacement")
        .key("stiffness", &T::stiffness, stiffness, "By which the support yields: force per displacement and moment "
             "per rotation since t = 0, of components that are not fixed.")
            .also("k spring springs spring_constant elastic subgrade foundation")
        .key("damping", &T::damping, damping, "Force and moment per rate, likewise.")
            .also("c dashpot viscosity")
        .key("vessel", &T::vessel, "The name of a [vessel.NAME]: what `fix` names, or the position, moves with it as if "
             "fixed to it.")
            .names_of({"vessel"}).also("attached_to ship fpso")
        .key("axes", &T::axes, "The support's own x, y and z directions, a row each: of length 1, at right angles, "
             "right-handed (to 1e-6). All else is along them; they stay.")
            .unit("1").otherwise("the global axes")
        .key("stages", &T::stages, "The stages in which the support holds. What it fixes it holds where that is; a "
             "move begins where the point is.")
            .otherwise("all").names_of({"stage"})
        .with(add_copies<T>)
        .at_least_one_of({"at", "where"})
        .at_least_one_of({"fix", "move", "stiffness", "damping", "vessel"})
        .at_most_one_of({"vessel", "move"})
        .at_most_one_of({"vessel", "axes"})
        .at_most_one_of({"vessel", "stiffness"})
        .at_most_one_of({"vessel", "damping"})
        .shown_by(
            "[[support]]\n"
            "at  = \"gyroscope\"\n"
            "fix = \"position\"\n"
            "\n"
            "[[support]]\n"
            "at        = \"flyer.start\"\n"
            "stiffness = { z = 2e4, rx = 50 }\n"
            "\n"
            "[[support]]\n"
            "at   = \"tail.end\"\n"
            "fix  = [\"y\", \"z\"]\n"
            "move = { x = \"0.1*sin(t)\" }\n"
            "axes = [[0, 0, 1], [1, 0, 0], [0, 1, 0]]\n");
    // clang-format on
    return table;
}

namespace {

NodeSupport& find_support(int node, std::vector<NodeSupport>& supports, std::vector<int>& by_node) {
    if (by_node[node] < 0) {
        by_node[node] = static_cast<int>(supports.size());
        supports.push_back({{.node = node}, {}, {}});
    }
    return supports[by_node[node]];
}

// Fixing one rotation alone would leave open what the other two mean once the point has turned.
void report_lone_fix(const NodeSupport& supported, std::size_t component, const BuildContext& context) {
    for (const CheckedWord& word : supported.holders[component]->fix->words) {
        if (word.word != component_names[component]) continue;
        return context.faults.add(
            word.place,
            word.path,
            fmt::format(
                "{} alone cannot be fixed: what stays free would depend on the path of the motion; "
                "expected two of rx, ry, rz (a hinge about the third axis), all three or none; or, for "
                "the turn about one axis, a joint of type \"free\" from the ground with move = {{ turn = 0 "
                "}}",
                word.word));
    }
}

// A rotation vector has a meaning as a whole only.
void report_incomplete_move(const NodeSupport& supported,
                            std::size_t component,
                            const BuildContext& context) {
    std::vector<std::string> free;
    for (std::size_t i = 3; i < 6; ++i) {
        if (!supported.support.holds(static_cast<int>(i))) free.emplace_back(component_names[i]);
    }
    const CheckedTimeFunction& value = *supported.holders[component]->move->components[component];
    const char* hint = free.size() == 2
                           ? "; or, for the turn about one axis, a joint of type \"free\" from the "
                             "ground with move = { turn = … }"
                           : "";
    context.faults.add(
        value.place,
        value.path,
        fmt::format("where a rotation moves, the other two must be fixed or moved too; free: {}{}",
                    plain_list(free),
                    hint));
}

void check_rotations(const NodeSupport& supported, const BuildContext& context) {
    const Support& support = supported.support;
    int held = 0;
    for (int i = 3; i < 6; ++i) held += support.holds(i) ? 1 : 0;
    if (held == 0 || held == 3) return;
    for (std::size_t i = 3; i < 6; ++i) {
        if (support.moved[i]) return report_incomplete_move(supported, i, context);
    }
    for (std::size_t i = 3; i < 6; ++i) {
        if (support.fixed[i] && held == 1) return report_lone_fix(supported, i, context);
    }
}

// A model without an unknown is a mistake, unless its supports move it.
void check_freedom(const std::vector<NodeSupport>& supports, const BuildContext& context) {
    const auto is_clamped = [](const NodeSupport& supported) {
        const auto& fixed = supported.support.fixed;
        return std::find(fixed.begin(), fixed.end(), false) == fixed.end();
    };
    const bool all_supported = !supports.empty() && supports.size() == context.model.nodes.size();
    if (!all_supported || !std::all_of(supports.begin(), supports.end(), is_clamped)) return;
    const SupportTable& first = *supports.front().tables.front();
    context.add_fault(first, first.fix, "every node of the deck is fixed; nothing can move");
}

// Whether what the table says of stiffness and damping makes a spring to the ground.
bool can_yield(const SupportTable& given, const BuildContext& context) {
    if (given.stages) {
        context.add_fault(
            given,
            given.stages,
            "a support that yields acts in all stages, as springs do; expected no stages, or fix "
            "in a table of its own");
        return false;
    }
    for (std::size_t i = 0; i < 6; ++i) {
        if (given.yields(i)) return true;
    }
    const auto refuse = [&](const auto& field) {
        context.add_fault(
            given, field, "all components are 0; expected one that is not, such as { z = 1e6 }");
    };
    given.stiffness ? refuse(given.stiffness) : refuse(given.damping);
    return false;
}

}  // namespace

void build_supports(BuildContext& context) {
    std::vector<NodeSupport> supports;
    std::vector<int> by_node(context.model.nodes.size(), -1);
    const double model_size = measure_size(context.model, {});
    for (const SupportTable& given : tables_of<SupportTable>(context.deck, support_table())) {
        if (!acts_in_stage(given, context)) continue;
        for (const PlacedPoint& point : find_points(given, given.at, given.where, context))
            merge_support(given, find_support(point.node, supports, by_node), context);
        if (!given.move) continue;
        for (std::size_t i = 0; i < 6; ++i) {
            const std::optional<CheckedTimeFunction>& move = given.move->components[i];
            if (move) check_move(*move, i < 3 ? model_size : 1.0, context);
        }
    }
    for (NodeSupport& supported : supports) {
        check_yielding(supported, context);
        if (!supported.holds_any()) continue;
        if (context.model.plane) hold_plane(supported, context);
        check_rotations(supported, context);
        context.model.supports.push_back(supported.support);
    }
    check_freedom(supports, context);
}

void build_yielding_supports(BuildContext& context) {
    std::size_t index = 0;
    for (const SupportTable& given : tables_of<SupportTable>(context.deck, support_table())) {
        const std::string name = fmt::format("{}{}]", support_prefix, index++);
        if (!given.yields() || !can_yield(given, context)) continue;
        Bushing bushing{
            .name = name, .carrier = BushingAxes::ground, .axes = find_axes(given, given.axes, context)};
        if (given.stiffness) bushing.stiffness.diagonal() = Vec6(given.stiffness->values.data());
        if (given.damping) bushing.damping.diagonal() = Vec6(given.damping->values.data());
        const std::vector<PlacedPoint> points = find_points(given, given.at, given.where, context);
        for (const PlacedPoint& point : points) {
            const Node& node = context.model.nodes[static_cast<std::size_t>(point.node)];
            if (points.size() > 1) bushing.name = name + " at " + node.name;
            bushing.ends[0].arm = node.position;
            bushing.ends[1].node = point.node;
            context.model.bushings.push_back(bushing);
        }
    }
}

}  // namespace gxrod
