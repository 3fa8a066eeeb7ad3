#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "model/joint.hpp"

// The card of a kind of joint: its word in decks, the coordinates that it leaves free, and how checks,
// summaries, results and reports treat it. They ask the card, and do not compare kinds.
namespace gxrod {

struct JointCard {
    JointKind kind;
    std::string_view word;
    std::string_view leaves_free;  // for readers of pages
    // How a summary continues the word; {axis}, {axis_b}, {held}, {lead} and {length} stand for the joint's.
    std::string_view summary = {};
    // Whether one turn about an axis, or one slide along it, is free.
    bool has_turn = false;
    bool has_slide = false;
    bool has_axis_b = false;      // B carries an axis of its own
    bool is_at_one_place = true;  // both points are at one place at t = 0
};

// In the order of JointKind.
inline constexpr std::array<JointCard, 13> joint_cards{
    {{.kind = JointKind::ball, .word = "ball", .leaves_free = "all turns"},
     {.kind = JointKind::hinge,
      .word = "hinge",
      .leaves_free = "turn about the axis",
      .summary = " about {axis}",
      .has_turn = true},
     {.kind = JointKind::cylinder,
      .word = "cylinder",
      .leaves_free = "turn about the axis, slide along it",
      .summary = " along {axis}",
      .has_turn = true,
      .has_slide = true},
     {.kind = JointKind::slider,
      .word = "slider",
      .leaves_free = "slide along the axis",
      .summary = " along {axis}",
      .has_slide = true},
     {.kind = JointKind::universal,
      .word = "universal",
      .leaves_free = "turns about both axes",
      .summary = " about {axis} of A and {axis_b} of B",
      .has_turn = true,
      .has_axis_b = true},
     {.kind = JointKind::screw,
      .word = "screw",
      .leaves_free = "turn about the axis, and a slide with it",
      .summary = " along {axis}, {lead:.6g} a turn,",
      .has_turn = true,
      .has_slide = true},
     {.kind = JointKind::plane,
      .word = "plane",
      .leaves_free = "slides across the axis, turn about it",
      .summary = " across {axis}",
      .has_turn = true},
     {.kind = JointKind::weld, .word = "weld", .leaves_free = "nothing"},
     {.kind = JointKind::distance,
      .word = "distance",
      .leaves_free = "all but the distance",
      .summary = " of {length:.6g}",
      .is_at_one_place = false},
     {.kind = JointKind::free,
      .word = "free",
      .leaves_free = "everything",
      .summary = " about and along {axis}",
      .has_turn = true,
      .has_slide = true},
     {.kind = JointKind::generic,
      .word = "generic",
      .leaves_free = "what `holds` does not name",
      .summary = ", held along and about {held} of the axes with x {axis},"},
     {.kind = JointKind::cam,
      .word = "cam",
      .leaves_free = "all but the distance of a roller from a curve, in the curve's plane",
      .summary = " in the plane across {axis}, of a curve {curve:.6g} long, roller {roller:.6g},",
      .is_at_one_place = false},
     {.kind = JointKind::sleeve,
      .word = "sleeve",
      .leaves_free = "slide along the rod, all turns unless turn = false",
      .has_slide = true}}};

constexpr const JointCard& card_of(JointKind kind) { return joint_cards[static_cast<std::size_t>(kind)]; }

}  // namespace gxrod
