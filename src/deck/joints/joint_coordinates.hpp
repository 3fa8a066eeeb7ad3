#pragma once

#include <string_view>
#include <vector>

#include "deck/places/build_context.hpp"

// Actions on the turn and the slide of a joint: its keys move, drive, spring, friction and limits.
namespace gxrod {

// Returns the coordinate of keys that do not name one; "" for a joint with both, whose keys have to name it.
std::string_view plain_coordinate(JointKind kind);

// Lists every f(t) of a [joint.NAME].
std::vector<const CheckedTimeFunction*> functions_of(const CheckedTable& joint);
// Lists the values of its `move`.
std::vector<CheckedNamedFunction> joint_moves_of(const CheckedTable& joint);
// Returns the coordinate, "turn" or "slide", of a value of `move` or `drive`.
std::string_view name_coordinate(const CheckedNamedFunction& value, JointKind kind);

// Adds faults of keys whose coordinate a joint of this kind lacks, or that contradict each other.
void check_coordinates(const CheckedTable& table, const Joint& joint, const BuildContext& context);

// Adds notes on numbers that are probably in another unit: the radius of a pin, limits of a turn. `size` is
// the size of the model.
void note_coordinates(const CheckedTable& table,
                      const Joint& joint,
                      double size,
                      const BuildContext& context);

// Sets turn and slide as they act in the current stage. `size` is the size of the model.
void set_coordinates(const CheckedTable& table, double size, Joint& joint, const BuildContext& context);

}  // namespace gxrod
