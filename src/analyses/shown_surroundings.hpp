#pragma once

#include "assembly/system.hpp"
#include "state/records/step_record.hpp"

namespace gxrod {

// Shows in the snapshot of a frame what water and ground press on rods, valid until the next call.
void show_surroundings(const System& system, const State& state, double time, Snapshot& snapshot);

}  // namespace gxrod
