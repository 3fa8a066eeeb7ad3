#pragma once

#include <optional>

#include "deck/problem.hpp"
#include "results/histories/history_point.hpp"

// The same problem, seen from axes that are turned: all of it, with its loads, gravity and supports, rotated
// about the origin: about z, if it has surroundings, in its plane, if it has one. Its motion is the turned
// motion, exactly.
namespace gxrod {

// The rotation, or of it what is about z where water, air or ground know up from down, and about the normal
// of a plane model; half a turn about z of a plane model in water, air or on the ground, whose plane is
// upright.
Quat restrict_rotation(const Quat& rotation, const Model& model);
// An axis of small turns that the model allows; nullopt of such a plane model.
std::optional<Vec3> find_small_turn(const Model& model);

void turn_model(const Quat& rotation, Model& model);
// The model and what histories are relative to.
void turn_problem(const Quat& rotation, Problem& problem);

// What turning a problem does to a quantity of a history.
enum class Turning {
    none,                 // components in axes that turn, too
    vector,               // v → R v
    attitude,             // q → R q
    rotation_since_start  // q → R q Rᵀ
};
Turning turning_of(Quantity quantity, const HistoryRequest& request);

// A row of the problem as it was, as the turned problem has it.
HistoryPoint::Row turn_row(Turning turning, const Quat& rotation, const HistoryPoint::Row& row);

}  // namespace gxrod
