#include "deck/joints/joints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "deck/joints/ends.hpp"
#include "deck/joints/joint_table.hpp"
#include "deck/schema/suggestion.hpp"
#include "deck/schema/top_level.hpp"
#include "deck/supports/components.hpp"
#include "model/settings/analysis_traits.hpp"
#include "model/settings/scheme_card.hpp"

namespace gxrod {
namespace {

// A joint that leaves everything free has to do something else.
void check_action(const JointTable& given, const BuildContext& context) {
    if (given.move || given.drive || given.spring || given.friction || given.limits) return;
    context.add_fault(
        given,
        given.type,
        "a free joint on which nothing acts does nothing; expected move, drive, spring, friction or limits");
}

void build_joint(const JointTable& given, double size, BuildContext& context) {
    if (given.is_sleeve()) return;
    Joint joint;
    joint.name = given.name;
    joint.kind = given.type;
    joint.lead = given.lead;
    if (joint.kind == JointKind::screw && joint.lead == 0.0)
        context.add_fault(
            given, given.lead, "a screw of lead 0 does not slide; expected a hinge, or another lead");
    if (given.holds) {
        for (const CheckedWord& word : given.holds->words) {
            const std::array<bool, 6> components = components_of(word.word);
            for (std::size_t i = 0; i < components.size(); ++i)
                joint.held[i] = joint.held[i] || components[i];
        }
    }
    if (given.clearance) joint.clearance = build_clearance(given, context);
    check_coordinates(given, context);
    if (joint.kind == JointKind::free) check_action(given, context);
    if (!place_joint(given, size, joint, context)) return;
    note_coordinates(given, joint, size, context);
    context.model.joints.push_back(std::move(joint));
}

// The joint of an end with a hinge: about y and z of its section; in a plane about its normal.
Joint make_member_hinge(const MemberHinge& hinge, const BuildContext& context) {
    const bool is_plane = top_level_of(context.deck).plane.has_value();
    Joint joint;
    joint.name = hinge.name;
    joint.kind = is_plane ? JointKind::ball : JointKind::universal;
    const Rod& rod = context.model.rods[static_cast<std::size_t>(hinge.rod)];
    const auto entry = std::ranges::find(rod.element_nodes, hinge.own_node) - rod.element_nodes.begin();
    const Mat3 axes = rod.triads[static_cast<std::size_t>(entry)].toRotationMatrix();
    const auto arm = [&](int node) -> Vec3 {
        const auto& nodes = context.model.nodes;
        return nodes[static_cast<std::size_t>(hinge.own_node)].position -
               nodes[static_cast<std::size_t>(node)].position;
    };
    joint.a.anchor = {.node = hinge.node, .arm = arm(hinge.node)};
    joint.b.anchor = {.node = hinge.own_node, .arm = Vec3::Zero()};
    joint.a.axes << axes.col(1), axes.col(2), axes.col(0);
    joint.b.axes << axes.col(2), axes.col(1), -axes.col(0);
    return joint;
}

// A joint that breaks leaves no equilibrium behind, from which a path or a steady motion could go on.
void check_breaks(const JointTable& given, const BuildContext& context) {
    const AnalysisSettings& analysis = context.stages[context.stage].analysis;
    if (!given.breaks || !(is_path(analysis) || std::holds_alternative<SteadySettings>(analysis))) return;
    context.add_fault(
        given,
        given.breaks,
        fmt::format("a stage of kind {} cannot go on from a joint that breaks; expected static, quasi-static "
                    "or dynamic stages",
                    kind_of(analysis)));
}

// Lists the stages in time in which the joint acts.
std::vector<std::size_t> list_timed_stages(const JointTable& given, const BuildContext& context) {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < context.stages.size(); ++i) {
        if (is_timed(context.stages[i].analysis) && acts_in_stage(given, i, context)) found.push_back(i);
    }
    return found;
}

// Finds the stage in which the joint breaks at a time; nullopt, with a fault in the first stage, if the deck
// does not say which.
std::optional<std::size_t> find_break_stage(const JointTable& given, const BuildContext& context) {
    const std::vector<std::size_t> timed = list_timed_stages(given, context);
    const auto refuse = [&](const auto& field, const std::string& message) {
        if (context.stage == 0) context.add_fault(*given.breaks, field, message);
        return std::nullopt;
    };
    if (const auto& name = given.breaks->stage) {
        const auto is_named = [&](std::size_t i) { return context.stages[i].name == name->word; };
        const auto found = std::ranges::find_if(timed, is_named);
        if (found != timed.end()) return *found;
        std::vector<std::string> names;
        for (const std::size_t i : timed) names.push_back(context.stages[i].name);
        const std::string nearest = did_you_mean(name->word, names);
        return refuse(
            name,
            fmt::format("no dynamic or quasi-static stage in which the joint acts has the name "
                        "\"{}\"; in others t is no time{}",
                        name->word,
                        nearest.empty() && !names.empty() ? "; expected " + plain_list(names) : nearest));
    }
    if (timed.size() == 1) return timed.front();
    if (timed.empty())
        return refuse(
            given.breaks->time,
            "the joint acts in no dynamic or quasi-static stage, and in others t is no time; expected "
            "such a stage, or a limit of what the joint holds");
    return refuse(
        given.breaks->time,
        "the joint acts in several stages with a time, each with its own t; expected `stage` with the name "
        "of one");
}

// Returns what the joint holds in the current stage, with a note where it outlasts the stage.
JointStrength find_strength(const JointTable& given, const BuildContext& context) {
    if (!given.breaks) return {};
    JointStrength strength{given.breaks->force, given.breaks->moment};
    const std::optional<double>& time = given.breaks->time;
    if (!time || find_break_stage(given, context) != context.stage) return strength;
    strength.time = time;
    const double end = end_of(context.analysis());
    if (*time > end)
        context.notes.push_back(fmt::format("{}: the stage ends at {:.6g}, before the joint breaks at {:.6g}",
                                            given.breaks->path_of(&given.breaks->time),
                                            end,
                                            *time));
    return strength;
}

// Stops begin to hold at the end of a step, of which an explicit scheme has no equations.
void check_stops(const JointTable& given, const Joint& joint, const BuildContext& context) {
    const auto* dynamic = std::get_if<DynamicSettings>(&context.stages[context.stage].analysis);
    if (dynamic == nullptr || !card_of(dynamic->scheme).is_explicit || !joint.has_stops()) return;
    const std::string_view word = card_of(dynamic->scheme).word;
    if (joint.pulls_only)
        context.add_fault(given,
                          given.slack,
                          fmt::format("a joint cannot become taut in {}, an explicit scheme; expected an "
                                      "implicit one, or a spring that only pulls",
                                      word));
    else if (joint.cam)
        context.add_fault(given,
                          given.lifts,
                          fmt::format("a roller cannot come back to its curve in {}, an explicit scheme; "
                                      "expected an implicit one, or lifts = false",
                                      word));
    else
        context.add_fault(
            given,
            given.limits,
            fmt::format("without stiffness they cannot begin to hold in {}, an explicit scheme; expected an "
                        "implicit one, or a stiffness",
                        word));
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
void check_sides(const JointTable& given,
                 const Joint& joint,
                 const std::vector<bool>& held,
                 const BuildContext& context) {
    for (const JointSide* side : {&joint.a, &joint.b}) {
        const Anchor& anchor = side->anchor;
        if (!anchor.is_ground() && !held[static_cast<std::size_t>(anchor.node)]) return;
    }
    const std::string& stage = context.stages[context.stage].name;
    context.add_fault(
        given,
        given.between,
        fmt::format("{}{}; expected a side that is free to move",
                    joint.has_ground() ? "a [[support]] holds all of the side that is not the ground"
                                       : "supports hold all of both sides",
                    stage.empty() ? "" : " in stage " + stage));
}

}  // namespace

void build_joints(BuildContext& context) {
    const double size = measure_size(context.model);
    for (const JointTable& given : tables_of<JointTable>(context.deck, joint_table()))
        build_joint(given, size, context);
    for (const MemberHinge& hinge : context.hinges)
        context.model.joints.push_back(make_member_hinge(hinge, context));
}

void build_joint_actions(BuildContext& context) {
    const double size = measure_size(context.model);
    const std::vector<bool> held = find_held_nodes(context.model);
    const auto tables = tables_of<JointTable>(context.deck, joint_table());
    auto table = tables.begin();
    for (Joint& joint : context.model.joints) {
        while (table != tables.end() && table->get().name != joint.name) ++table;
        if (table == tables.end()) return;  // hinges of members come last, on which nothing acts
        const JointTable& given = *table;
        set_coordinates(given, size, joint, context);
        joint.acts = acts_in_stage(given, context);
        joint.strength = find_strength(given, context);
        check_breaks(given, context);
        check_stops(given, joint, context);
        if (joint.acts) check_sides(given, joint, held, context);
        check_motors(given, size, context);
    }
}

}  // namespace gxrod
