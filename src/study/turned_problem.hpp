#pragma once

#include <optional>

#include "deck/problem.hpp"
#include "results/histories/history_point.hpp"

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

// The effect of turning a problem on a quantity of a history.
enum class Turning {
    none,                 // components in axes that turn, too
    vector,               // v → R v
    attitude,             // q → R q
    rotation_since_start  // q → R q Rᵀ
};
Turning turning_of(Quantity quantity, const HistoryRequest& request);

// Turns a row of the original problem into the row that the turned problem has.
HistoryPoint::Row turn_row(Turning turning, const Quat& rotation, const HistoryPoint::Row& row);

}  // namespace gxrod
