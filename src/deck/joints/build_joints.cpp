#include "deck/joints/build_joints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "deck/checks/check_moves.hpp"
#include "deck/joints/ends.hpp"
#include "deck/joints/joint_coordinates.hpp"
#include "deck/joints/joint_sides.hpp"
#include "deck/schema/choices.hpp"

namespace gxrod {
namespace {

// A joint that leaves everything free has to do something else.
void check_action(const CheckedTable& table, const BuildContext& context) {
    constexpr std::array<const char*, 5> actions{"move", "drive", "spring", "friction", "limits"};
    if (std::ranges::any_of(actions, [&](const char* key) { return table.gives(key); })) return;
    context.add_fault(
        table,
        "type",
        "a free joint on which nothing acts does nothing; expected move, drive, spring, friction or limits");
}

void build_joint(const CheckedTable& table, double size, BuildContext& context) {
    Joint joint;
    joint.name = table.name;
    joint.kind = value_of(joint_kind_choices, table.get<std::string>("type"));
    if (joint.kind == JointKind::sleeve) return;
    if (table.gives("lead")) joint.lead = table.get<double>("lead");
    if (joint.kind == JointKind::screw && joint.lead == 0.0)
        context.add_fault(
            table, "lead", "a screw of lead 0 does not slide; expected a hinge, or another lead");
    check_coordinates(table, joint, context);
    if (joint.kind == JointKind::free) check_action(table, context);
    if (!place_joint(table, size, joint, context)) return;
    note_coordinates(table, joint, size, context);
    context.model.joints.push_back(std::move(joint));
}

// Of nodes and joints.
double measure_size(const Model& model) {
    std::vector<Anchor> anchors;
    for (const Joint& joint : model.joints) anchors.insert(anchors.end(), {joint.a.anchor, joint.b.anchor});
    return measure_size(model, anchors);
}

// By node: whether a support holds all of it.
std::vector<bool> find_held_nodes(const Model& model) {
    std::vector<bool> held(model.nodes.size());
    for (const Support& support : model.supports)
        held[static_cast<std::size_t>(support.node)] = support.holds_all(0) && support.holds_all(3);
    return held;
}

// A joint needs a side that it can move.
void check_sides(const CheckedTable& table,
                 const Joint& joint,
                 const std::vector<bool>& held,
                 const BuildContext& context) {
    for (const JointSide* side : {&joint.a, &joint.b}) {
        const Anchor& anchor = side->anchor;
        if (!anchor.is_ground() && !held[static_cast<std::size_t>(anchor.node)]) return;
    }
    const std::string& stage = context.stages[context.stage].name;
    context.add_fault(
        table,
        "between",
        fmt::format("{}{}; expected a side that is free to move",
                    joint.has_ground() ? "a [[support]] holds all of the side that is not the ground"
                                       : "supports hold all of both sides",
                    stage.empty() ? "" : " in stage " + stage));
}

void check_moves(const CheckedTable& table, double size, const Joint& joint, const BuildContext& context) {
    for (const CheckedNamedFunction& move : joint_moves_of(table)) {
        const bool is_turn = name_coordinate(move, joint.kind) == "turn";
        check_move(move.value, is_turn ? 1.0 : size, context);
    }
}

}  // namespace

void build_joints(BuildContext& context) {
    const double size = measure_size(context.model);
    for (const CheckedTable& table : context.deck.tables("joint")) build_joint(table, size, context);
}

void build_joint_actions(BuildContext& context) {
    const double size = measure_size(context.model);
    const std::vector<bool> held = find_held_nodes(context.model);
    auto table = context.deck.tables("joint").begin();
    for (Joint& joint : context.model.joints) {
        while (table->name != joint.name) ++table;
        set_coordinates(*table, size, joint, context);
        check_sides(*table, joint, held, context);
        check_moves(*table, size, joint, context);
    }
}

}  // namespace gxrod
