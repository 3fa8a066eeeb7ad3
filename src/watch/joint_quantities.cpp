#include "watch/quantity_tables.hpp"

namespace gxrod {
namespace {

// The joint itself, or a sleeve as a joint.
Joint joint_of(const Watched& target, const Model& model) {
    const WatchedTie& tie = std::get<WatchedTie>(target);
    const auto index = static_cast<std::size_t>(tie.index);
    if (tie.kind == TieKind::joint) return model.joints[index];
    Joint joint;
    joint.kind = JointKind::sleeve;
    joint.slide = model.sleeves[index].slide;
    return joint;
}

bool has_drive(const JointCoordinate& one) { return one.motion || !one.drive.is_zero(); }

std::string lacks_turn(const Watched& target, const Model& model) {
    return joint_of(target, model).has_turn() ? "" : "this joint has no turn about one axis";
}

std::string lacks_slide(const Watched& target, const Model& model) {
    return joint_of(target, model).has_slide() ? "" : "this joint has no slide";
}

// What drives a coordinate, or rubs there, is 0 where nothing does.
std::string lacks_drive(const Watched& target, const Model& model) {
    const Joint joint = joint_of(target, model);
    if (has_drive(joint.turn) && has_drive(joint.slide))
        return "this joint has two motors; force_a and moment_a show both, along the axis";
    return joint.has_turn() || joint.has_slide()
               ? ""
               : "this joint has no turn about one axis and no slide that it could drive";
}

std::string lacks_friction(const Watched& target, const Model& model) {
    const Joint joint = joint_of(target, model);
    if (joint.turn.friction.acts() && joint.slide.friction.acts())
        return "this joint has two frictions; expected one";
    return joint.has_turn() || joint.has_slide()
               ? ""
               : "this joint has no turn about one axis and no slide that could rub";
}

std::string lacks_clearance(const Watched& target, const Model& model) {
    return joint_of(target, model).clearance ? "" : "this joint has no clearance";
}

std::string lacks_curve(const Watched& target, const Model& model) {
    return joint_of(target, model).cam ? "" : "this joint has no curve; a cam has one";
}

const char* dimension_of_slide(bool is_of_slide) { return is_of_slide ? "force" : "force·length"; }

const char* dimension_of_drive(const Watched& target, const Model& model) {
    const Joint joint = joint_of(target, model);
    return dimension_of_slide(has_drive(joint.slide) || !joint.has_turn());
}

const char* dimension_of_friction(const Watched& target, const Model& model) {
    const Joint joint = joint_of(target, model);
    return dimension_of_slide(joint.slide.friction.acts() || !joint.has_turn());
}

const char* dimension_of_gear(const Watched& target, const Model& model) {
    const Gear& gear = model.gears[static_cast<std::size_t>(std::get<WatchedTie>(target).index)];
    return dimension_of_slide(!gear.sides[1].is_turn);
}

const char* dimension_of_play(const Watched& target, const Model& model) {
    const Gear& gear = model.gears[static_cast<std::size_t>(std::get<WatchedTie>(target).index)];
    return gear.sides[1].is_turn ? "angle" : "length";
}

// Forces are those that A exerts on B. Of both drives one at most is not 0.
// clang-format off
constexpr Quantity joint_lines[]{
    Quantity("angle", "turn of B against A since t = 0, any number of turns", "angle", Axes::none,
             [](const Sight& see) { return see.joint().turn; }).unless(lacks_turn),
    Quantity("angle_rate", "rate of the angle", "angle/time", Axes::none,
             [](const Sight& see) { return see.joint().turn_rate; }).unless(lacks_turn),
    Quantity("slide", "slide of B along the axis since t = 0", "length", Axes::none,
             [](const Sight& see) { return see.joint().slide; }).unless(lacks_slide),
    Quantity("slide_rate", "rate of the slide", "length/time", Axes::none,
             [](const Sight& see) { return see.joint().slide_rate; }).unless(lacks_slide),
    Quantity("force", "force that A exerts on B", "force", Axes::global,
             [](const Sight& see) { return see.joint().force; }).with_strain_order(),
    Quantity("moment", "moment that A exerts on B, about the joint", "force·length", Axes::global,
             [](const Sight& see) { return see.joint().moment; }).with_strain_order(),
    Quantity("force_a", "force that A exerts on B (along the axis, across it)", "force", Axes::joint,
             [](const Sight& see) { return see.joint().force_in_joint; }),
    Quantity("moment_a", "moment that A exerts on B (about the axis, across it)", "force·length", Axes::joint,
             [](const Sight& see) { return see.joint().moment_in_joint; }),
    Quantity("drive", "moment that drives a turn, force that drives a slide", "force·length", Axes::none,
             [](const Sight& see) { return see.joint().drive_turn + see.joint().drive_slide; })
        .sized(Size::unknown).unless(lacks_drive).measured(dimension_of_drive),
    Quantity("friction", "moment of the friction of a turn, force of that of a slide", "force·length", Axes::none,
             [](const Sight& see) { return see.joint().friction; })
        .sized(Size::unknown).unless(lacks_friction).measured(dimension_of_friction),
    Quantity("play", "distance of the points of a joint with clearance, across its axis", "length", Axes::none,
             [](const Sight& see) { return see.joint().play; }).unless(lacks_clearance),
    Quantity("normal_force", "force of a cam's curve on the roller across it, positive if it pushes", "force", Axes::none,
             [](const Sight& see) { return see.joint().normal_force; }).unless(lacks_curve),
    Quantity("curve_place", "arc length of a cam's curve from its first point to where the roller is", "length", Axes::none,
             [](const Sight& see) { return see.joint().curve_place; }).unless(lacks_curve),
    Quantity("curve_gap", "distance of the roller from a cam's curve", "length", Axes::none,
             [](const Sight& see) { return see.joint().curve_gap; }).unless(lacks_curve),
    Quantity("gap", "how far the joint's equations are from being satisfied", "length", Axes::none,
             [](const Sight& see) { return see.joint().gap; }),
    Quantity("holds", "1 while the joint holds, 0 where it does not act or is broken", "1", Axes::none,
             [](const Sight& see) { return see.joint().holds ? 1.0 : 0.0; })};

constexpr Quantity gear_lines[]{
    Quantity("drive",
             "moment, or force, of the gear on B of its second joint along that one's coordinate; on the first one "
             "ratio times it", "force·length", Axes::none,
             [](const Sight& see) { return see.joint().drive_turn + see.joint().drive_slide; })
        .sized(Size::unknown).measured(dimension_of_gear),
    Quantity("play", "ratio × first + second, which teeth with backlash leave free within a range", "angle", Axes::none,
             [](const Sight& see) { return see.joint().play; })
        .sized(Size::unknown).measured(dimension_of_play),
    Quantity("gap", "how far the gear's equation is from being satisfied", "length", Axes::none,
             [](const Sight& see) { return see.joint().gap; })};
// clang-format on

}  // namespace

constinit const QuantityTable quantities_of_joints{joint_lines, SnapshotPart::ties, "joints"};
constinit const QuantityTable quantities_of_gears{
    gear_lines, SnapshotPart::ties, "gears", "a gear has drive, play and gap only; its joints have the rest"};

}  // namespace gxrod
