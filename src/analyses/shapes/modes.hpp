#pragma once

#include "assembly/system.hpp"
#include "model/settings/settings.hpp"
#include "state/records/mode_record.hpp"

namespace gxrod {

// The modes of vibration about the trial motions of a state, with loads at `time`: undamped, by the symmetric
// part of the stiffness (docs/theory/vibrations.md). Copies of a multiple frequency are turned so that the
// first ones move the model along and about the axes as far as they can, and signs make the largest component
// positive: equal models give equal shapes.
ModesRecord find_modes(const System& system, const State& state, double time, const ModesSettings& settings);

}  // namespace gxrod
