#pragma once

#include "deck/places/build_context.hpp"

namespace gxrod {

// Adds faults of a prescribed motion in the current stage, if the stage has time: jumps, and in the first
// stage a value at t = 0 other than 0. `size` is the size of the model for displacements, 1 rad for turns.
void check_move(const CheckedTimeFunction& move, double size, const BuildContext& context);

}  // namespace gxrod
