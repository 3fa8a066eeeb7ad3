#pragma once

#include "assembly/system.hpp"
#include "state/records/step_record.hpp"

namespace gxrod {

// Shows in a snapshot whether there is ground and, for a frame, what water and ground press on rods, valid
// until the next call.
void show_surroundings(
    const System& system, const State& state, double time, bool is_for_frame, Snapshot& snapshot);

}  // namespace gxrod
