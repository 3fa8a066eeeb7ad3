#pragma once

#include "deck/places/build_context.hpp"

namespace gxrod {

// Faults of what prescribes a motion in the stage at hand, if that is in time: in the first stage a value at
// t = 0 that is not 0, and jumps. `size` is that of what moves: the model, or 1 rad.
void check_move(const CheckedTimeFunction& move, double size, const BuildContext& context);

}  // namespace gxrod
