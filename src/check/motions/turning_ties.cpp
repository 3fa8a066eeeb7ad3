#include "check/motions/turning_ties.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>

#include "elements/carried_bushing_motion.hpp"
#include "model/ties/ties.hpp"
#include "rotation/cross_products.hpp"
#include "rotation/vector_text.hpp"

namespace gxrod {

namespace {

// What is written with ten digits counts as exact.
constexpr double as_written = 1e-9;

bool is_on_axis(const Vec3& point, const TurningFrame& frame) {
    const Vec3 arm = point - frame.through;
    return frame.axis.cross(arm).norm() <= as_written * std::max(arm.norm(), point.norm());
}

bool is_axis_of(const TurningFrame& frame, const Vec3& direction) {
    return are_parallel(direction, frame.axis);
}

// The place of a tie on the ground, if it has one.
const Vec3* find_ground(const std::array<Anchor, 2>& ends) {
    for (const Anchor& end : ends) {
        if (end.is_ground()) return &end.arm;
    }
    return nullptr;
}

// The reason why a tie is not steady, and what to do: parts of sentences, empty if it is alike to all sides.
struct Cause {
    std::string what = {}, remedy = {};
};

const Cause off_axis{"is tied to the ground off the axis", "Tie it to a point of the axis"};

Cause find_cause(const Spring& spring, const TurningFrame& frame) {
    const Vec3* ground = find_ground(spring.ends);
    if (ground == nullptr || is_on_axis(*ground, frame)) return {};
    return off_axis;
}

// Of a bushing whose axes the ground carries, or which an end carries that is the ground.
Cause find_cause_of_bearing(const Bushing& bushing, const TurningFrame& frame) {
    const Vec3 axis = bushing.axes.conjugate() * frame.axis;
    if (!is_alike_about(axis, bushing.stiffness) || !is_alike_about(axis, bushing.damping)) {
        return {"is not equally stiff and damped to all sides of the axis",
                "Make it so, let what is alike to all sides spin in a frame at rest (rotation.spins)"};
    }
    const Vec3* ground = find_ground(bushing.ends);
    if (ground == nullptr) return {};
    const Vec3 sideways = bushing.axes.conjugate() * frame.axis.cross(*ground - frame.through);
    const Vec6 change = bushing.stiffness.leftCols<3>() * sideways;
    if (change.norm() > as_written * bushing.stiffness.norm() * (*ground - frame.through).norm())
        return off_axis;
    return {};
}

// Of a bushing that turns with one end, where the other one is the ground.
Cause find_cause_of_carried(const Bushing& bushing, const TurningFrame& frame) {
    const Vec3* ground = find_ground(bushing.ends);
    if (ground == nullptr || is_on_axis(*ground, frame)) return {};
    return off_axis;
}

Cause find_cause(const Bushing& bushing, const TurningFrame& frame) {
    const bool has_ground = bushing.has_ground();
    if (!has_ground && bushing.carrier != BushingAxes::ground) return {};
    if (bushing.has_axes_between())
        return {"has axes half way between the ground and what turns",
                "Let the ground carry them, axes = \"ground\""};
    const BushingTurn turn = find_bushing_turn(bushing);
    const bool is_swing = turn.kind == BushingTurn::Kind::swing;
    if (has_ground && turn.kind == BushingTurn::Kind::vector)
        return {"has a stiffness that holds the turn about the axis", "Leave that component out"};
    if (is_swing && !is_axis_of(frame, bushing.axes * Vec3::Unit(turn.axis)))
        return {"resists tilts about one direction across the axis alone", "Let it resist all tilts alike"};
    const bool is_carried = (carries_axes(bushing, 0) && !bushing.ends[0].is_ground()) ||
                            (carries_axes(bushing, 1) && !bushing.ends[1].is_ground());
    return is_carried ? find_cause_of_carried(bushing, frame) : find_cause_of_bearing(bushing, frame);
}

bool is_idle(const JointCoordinate& laws) {
    return !depends_on_turn(laws) && laws.damping == 0.0 && laws.drive.is_zero();
}

// Whether the turn of a joint to the ground is about the axis: a universal joint turns about the one that A
// carries.
bool turns_about_axis(const Joint& joint) {
    return !card_of(joint.kind).has_axis_b || joint.a.anchor.is_ground();
}

Cause find_cause(const Joint& joint, const TurningFrame& frame) {
    if (!joint.has_ground()) return {};
    const TurningJointCard& card = turning_card_of(joint.kind);
    if (!card.holds_something && is_idle(joint.turn) && is_idle(joint.slide)) return {};
    if (!card.is_alike)
        return {"does not hold all directions alike against the ground",
                "Take a hinge or a cylinder along the axis, or a ball"};
    if (card.holds_turn)
        return {"holds the turn about the axis against the ground",
                fmt::format("Take a hinge or a cylinder along the axis instead of a {}",
                            card_of(joint.kind).word)};
    const JointSide& ground = joint.a.anchor.is_ground() ? joint.a : joint.b;
    if (card.asks_place && !is_on_axis(ground.anchor.arm, frame)) return off_axis;
    if (!card.has_axis) return {};
    if (!is_axis_of(frame, ground.axes.col(0)))
        return {fmt::format("is tied to the ground with the axis {}", in_brackets(ground.axes.col(0))),
                "Give it the axis of rotation"};
    if (turns_about_axis(joint) && depends_on_turn(joint.turn))
        return {"has a spring, friction, limits or a motor on the turn against the ground",
                "Leave a damping or a drive"};
    return {};
}

Cause find_cause(const Model& model, const Gear& gear) {
    for (const GearSide& side : gear.sides) {
        const Joint& joint = model.joints[static_cast<std::size_t>(side.joint)];
        if (side.is_turn && joint.has_ground() && turns_about_axis(joint))
            return {fmt::format("couples the turn of joint {} against the ground", joint.name),
                    "Leave the gear out"};
    }
    return {};
}

Cause find_cause(const Sleeve& sleeve, const TurningFrame& frame) {
    if (!sleeve.point.is_ground()) return {};
    if (sleeve.holds_turn)
        return {"holds the turn about the axis against the ground", "Leave out turn = false"};
    return is_on_axis(sleeve.point.arm, frame) ? Cause{} : off_axis;
}

Cause find_cause(const Model& model, const Tie& tie, const TurningFrame& frame) {
    switch (tie.kind) {
        case TieKind::spring:
            return find_cause(model.springs[tie.index], frame);
        case TieKind::bushing:
            return find_cause(model.bushings[tie.index], frame);
        case TieKind::joint:
            return find_cause(model.joints[tie.index], frame);
        case TieKind::gear:
            return find_cause(model, model.gears[tie.index]);
        case TieKind::sleeve:
            return find_cause(model.sleeves[tie.index], frame);
    }
    return {};
}

}  // namespace

bool depends_on_turn(const JointCoordinate& turn) {
    return turn.motion || turn.stiffness != 0.0 || turn.friction.acts() || turn.limits.lower ||
           turn.limits.upper;
}

bool are_parallel(const Vec3& one, const Vec3& other) {
    return one.cross(other).norm() <= as_written * one.norm() * other.norm();
}

bool is_alike_about(const Vec3& axis, const Mat6& matrix) {
    Mat6 turn = Mat6::Zero();
    turn.topLeftCorner<3, 3>() = turn.bottomRightCorner<3, 3>() = cross_matrix<double>(axis);
    const Mat6 change = turn * matrix - matrix * turn;
    // Forces and moments have units of their own.
    for (const int row : {0, 3}) {
        for (const int column : {0, 3}) {
            if (change.block<3, 3>(row, column).norm() > as_written * matrix.block<3, 3>(row, column).norm())
                return false;
        }
    }
    return true;
}

std::string find_unsteady_tie(const Model& model, const TurningFrame& frame) {
    for (const Tie& tie : list_ties(model)) {
        const auto [what, remedy] = find_cause(model, tie, frame);
        if (what.empty()) continue;
        return fmt::format(
            "{} {}: in a frame that turns about {} it is not steady. {}, or make the motion a dynamic "
            "analysis",
            key_of(tie),
            what,
            in_brackets(frame.axis),
            remedy);
    }
    return "";
}

}  // namespace gxrod
