#pragma once

#include <optional>

#include "deck/problem.hpp"
#include "watch/quantity.hpp"

// A problem rotated as a whole, with loads, gravity and supports, about the origin: about z if it has
// surroundings, in its plane if it has one. Its exact motion is the original motion, rotated likewise.
namespace gxrod {

// Restricts a rotation to the part that the model allows: its part about z if water, air or ground give it a
// vertical direction, and its part about the normal of a plane model; half a turn about z for a plane model
// in water, air or on the ground, whose plane is upright.
Quat restrict_rotation(const Quat& rotation, const Model& model);
// Finds an axis of small turns that the model allows; nullopt for an upright plane model.
std::optional<Vec3> find_small_turn(const Model& model);

void turn_model(const Quat& rotation, Model& model);
// Turns the model and the reference frames of histories.
void turn_problem(const Quat& rotation, Problem& problem);

// Turns a row of the original problem into the row that the turned problem has.
HistoryRow turn_row(Turning turning, const Quat& rotation, const HistoryRow& row);

}  // namespace gxrod
