#pragma once

#include <algorithm>
#include <array>
#include <string>

#include "model/model.hpp"
#include "model/settings/turning_frame.hpp"
#include "model/ties/joint_card.hpp"

namespace gxrod {

// Returns the reason why a spring, a bushing or a joint is not steady in a frame that turns, a sentence: it
// is tied to the ground, and is not alike to all sides of the axis of rotation. "" if all are.
std::string find_unsteady_tie(const Model& model, const TurningFrame& frame);

// The card of a kind of joint between a part that turns about an axis and one that does not: what it asks to
// be alike to all sides.
struct TurningJointCard {
    JointKind kind;
    bool holds_turn = false;      // about its own axis, or any
    bool has_axis = false;        // which must be that of the rotation
    bool asks_place = true;       // whether its point must be on that axis
    bool holds_something = true;  // otherwise only what acts on its coordinates counts
    bool is_alike = true;         // whether what it holds can be alike to all sides
};

// In the order of JointKind.
inline constexpr std::array<TurningJointCard, joint_cards.size()> turning_joint_cards{
    {{.kind = JointKind::ball},
     {.kind = JointKind::hinge, .has_axis = true},
     {.kind = JointKind::cylinder, .has_axis = true},
     {.kind = JointKind::slider, .holds_turn = true, .has_axis = true},
     {.kind = JointKind::universal, .has_axis = true},
     {.kind = JointKind::screw, .holds_turn = true, .has_axis = true},
     {.kind = JointKind::plane, .has_axis = true, .asks_place = false},
     {.kind = JointKind::weld, .holds_turn = true},
     {.kind = JointKind::distance},
     {.kind = JointKind::free, .has_axis = true, .holds_something = false},
     {.kind = JointKind::generic, .is_alike = false},
     {.kind = JointKind::cam, .is_alike = false},
     {.kind = JointKind::sleeve}}};

static_assert(
    std::ranges::equal(turning_joint_cards, joint_cards, {}, &TurningJointCard::kind, &JointCard::kind));

constexpr const TurningJointCard& turning_card_of(JointKind kind) {
    return turning_joint_cards[static_cast<std::size_t>(kind)];
}

// Whether what acts on a joint's turn depends on the angle, or on more of its rate than a damping does.
bool depends_on_turn(const JointCoordinate& turn);
// Whether two vectors have one direction or opposite ones.
bool are_parallel(const Vec3& one, const Vec3& other);
// Whether a matrix of forces and moments by displacements and rotations commutes with turns about an axis,
// both in the same axes.
bool is_alike_about(const Vec3& axis, const Mat6& matrix);

}  // namespace gxrod
