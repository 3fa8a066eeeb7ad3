#include "check/summaries/joint_summary.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

#include "model/ties/joint_card.hpp"
#include "rotation/vector_text.hpp"

namespace gxrod {
namespace {

// "y, z".
std::string list_held(const Joint& joint) {
    std::vector<std::string_view> words;
    for (std::size_t i = 0; i < joint.held.size(); ++i) {
        if (joint.held[i]) words.push_back(component_names[i]);
    }
    return fmt::format("{}", fmt::join(words, ", "));
}

std::string describe_strength(const JointStrength& strength) {
    std::string text;
    if (strength.force) text += fmt::format("; breaks at a force of {:.6g}", *strength.force);
    if (strength.moment)
        text += fmt::format("{} a moment of {:.6g}", text.empty() ? "; breaks at" : " or", *strength.moment);
    if (strength.time)
        text += fmt::format("{} t = {:.6g}", text.empty() ? "; breaks at" : " or", *strength.time);
    return text;
}

std::string describe_clearance(const JointClearance& clearance) {
    const CoordinateLimits& contact = clearance.contact;
    std::string text = fmt::format("; clearance {:.6g} (stiffness {:.6g}", *contact.upper, contact.stiffness);
    if (contact.exponent != 1.0) text += fmt::format(", exponent {:.6g}", contact.exponent);
    if (clearance.friction > 0.0) text += fmt::format(", friction {:.6g}", clearance.friction);
    return text + ")";
}

// "", or what the teeth of a gear leave free.
std::string describe_teeth(const std::optional<CoordinateLimits>& teeth) {
    if (!teeth) return "";
    return fmt::format(
        " within a backlash of {:.6g}, stiffness {:.6g}", *teeth->upper - *teeth->lower, teeth->stiffness);
}

// The axes of a joint, or the length of a distance, with what it has to do with them.
std::string describe_axes(const Joint& joint) {
    return fmt::format(fmt::runtime(card_of(joint.kind).summary),
                       fmt::arg("axis", in_parentheses(joint.a.axes.col(0))),
                       fmt::arg("axis_b", in_parentheses(joint.b.axes.col(0))),
                       fmt::arg("held", list_held(joint)),
                       fmt::arg("lead", joint.lead),
                       fmt::arg("length", joint.length),
                       fmt::arg("curve", joint.cam ? joint.cam->curve->length() : 0.0),
                       fmt::arg("roller", joint.cam ? joint.cam->roller : 0.0));
}

// A side of a joint whose place is told: "thigh.end", "shank (by an arm of 0.12)".
std::string name_side(const Model& model, const Anchor& anchor) {
    if (anchor.is_ground()) return "the ground";
    const std::string& node = model.nodes[anchor.node].name;
    return anchor.arm.isZero(0.0) ? node : fmt::format("{} (by an arm of {:.6g})", node, anchor.arm.norm());
}

std::string describe_limits(const CoordinateLimits& limits) {
    const std::string stiffness =
        limits.are_rigid() ? " (stops)" : fmt::format(" (stiffness {:.6g})", limits.stiffness);
    if (!limits.lower) return fmt::format("limit below {:.6g}", *limits.upper) + stiffness;
    if (!limits.upper) return fmt::format("limit above {:.6g}", *limits.lower) + stiffness;
    return fmt::format("limits {:.6g} to {:.6g}", *limits.lower, *limits.upper) + stiffness;
}

// What acts on a coordinate; "" if nothing does.
std::string describe_actions(const char* name, const JointCoordinate& coordinate) {
    std::vector<std::string> actions;
    if (coordinate.motion) actions.emplace_back("moved by a motor");
    if (!coordinate.drive.is_zero()) actions.emplace_back("driven");
    if (coordinate.stiffness > 0.0)
        actions.push_back(fmt::format("spring of stiffness {:.6g}", coordinate.stiffness));
    if (coordinate.damping > 0.0) actions.push_back(fmt::format("damping {:.6g}", coordinate.damping));
    if (coordinate.friction.force > 0.0)
        actions.push_back(fmt::format("friction {:.6g}", coordinate.friction.force));
    if (coordinate.friction.lever > 0.0)
        actions.push_back(fmt::format("friction {:.6g} times the force held", coordinate.friction.lever));
    if (coordinate.limits.lower || coordinate.limits.upper)
        actions.push_back(describe_limits(coordinate.limits));
    return actions.empty() ? "" : fmt::format("; {}: {}", name, fmt::join(actions, ", "));
}

std::string describe_joint(const Model& model, const Joint& joint) {
    const JointCard& card = card_of(joint.kind);
    std::string text = fmt::format("joint {}: {}{}", joint.name, card.word, describe_axes(joint));
    if (joint.pulls_only) text += " at most,";
    if (joint.cam && joint.cam->lifts) text += " which may lift off,";
    if (card.is_at_one_place) {
        text += fmt::format(" at {} between {} and {}",
                            in_parentheses(find_place(model, joint.a.anchor)),
                            name_side(model, joint.a.anchor),
                            name_side(model, joint.b.anchor));
    } else {
        text += fmt::format(" between {} and {}",
                            describe_anchor(model, joint.a.anchor),
                            describe_anchor(model, joint.b.anchor));
    }
    return text + describe_actions("turn", joint.turn) + describe_actions("slide", joint.slide) +
           (joint.clearance ? describe_clearance(*joint.clearance) : "") + describe_strength(joint.strength) +
           "\n";
}

std::string describe_sleeve(const Model& model, const Sleeve& sleeve) {
    const Rod& rod = model.rods[sleeve.rod];
    return fmt::format("joint {}: sleeve at {} between rod {}, {:.6g} of {:.6g} along it, and {}{}{}\n",
                       sleeve.name,
                       in_parentheses(find_place(model, sleeve.point)),
                       rod.name,
                       sleeve.place,
                       rod.length,
                       name_side(model, sleeve.point),
                       sleeve.holds_turn ? ", which does not turn against the section" : "",
                       describe_actions("slide", sleeve.slide));
}

}  // namespace

std::string describe_anchor(const Model& model, const Anchor& anchor) {
    if (anchor.is_ground()) return fmt::format("the ground at {}", in_parentheses(anchor.arm));
    const std::string& node = model.nodes[anchor.node].name;
    if (anchor.arm.isZero(0.0)) return node;
    return fmt::format(
        "{} by an arm of {:.6g} to {}", node, anchor.arm.norm(), in_parentheses(find_place(model, anchor)));
}

ItemList list_gears(const Model& model) {
    ItemList gears{"gears", {}};
    for (const Gear& gear : model.gears) {
        const auto name = [&](const GearSide& side) {
            return fmt::format("{} of {}", side.is_turn ? "turn" : "slide", model.joints[side.joint].name);
        };
        gears.items.push_back(fmt::format("gear {}: {:.6g} × {} + {} = 0{}\n",
                                          gear.name,
                                          gear.ratio,
                                          name(gear.sides[0]),
                                          name(gear.sides[1]),
                                          describe_teeth(gear.teeth)));
    }
    return gears;
}

ItemList list_joints(const Model& model) {
    ItemList joints{"joints", {}};
    for (const Joint& joint : model.joints) joints.items.push_back(describe_joint(model, joint));
    for (const Sleeve& sleeve : model.sleeves) joints.items.push_back(describe_sleeve(model, sleeve));
    return joints;
}

}  // namespace gxrod
