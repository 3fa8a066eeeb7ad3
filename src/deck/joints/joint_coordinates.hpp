#pragma once

#include <string_view>
#include <vector>

#include "deck/places/build_context.hpp"

// What acts on the turn and the slide of a joint: its keys move, drive, spring, friction and limits.
namespace gxrod {

// What keys without a coordinate's name are about; "" of a joint with both, whose keys have to say.
std::string_view plain_coordinate(JointKind kind);

// Every f(t) of a [joint.NAME].
std::vector<const CheckedTimeFunction*> functions_of(const CheckedTable& joint);
// The values of its `move`.
std::vector<CheckedNamedFunction> joint_moves_of(const CheckedTable& joint);
// The coordinate, "turn" or "slide", that a value of `move` or `drive` is about.
std::string_view name_coordinate(const CheckedNamedFunction& value, JointKind kind);

// Faults of keys that a joint of this kind has no coordinate for, or that contradict each other.
void check_coordinates(const CheckedTable& table, const Joint& joint, const BuildContext& context);

// Notes on numbers that are likely in another unit: the radius of a pin, limits of a turn. `size` is that of
// the model.
void note_coordinates(const CheckedTable& table,
                      const Joint& joint,
                      double size,
                      const BuildContext& context);

// Turn and slide as they act in the stage at hand. `size` is that of the model.
void set_coordinates(const CheckedTable& table, double size, Joint& joint, const BuildContext& context);

}  // namespace gxrod
