#pragma once

#include "assembly/system.hpp"
#include "model/settings/settings.hpp"
#include "state/records/mode_record.hpp"

namespace gxrod {

// Finds the modes of vibration about the trial motions of a state, with loads at `time`: undamped, with the
// symmetric part of the stiffness (docs/theory/vibrations.md). Modes of a multiple frequency are combined so
// that the first ones move the model along and about the axes as far as possible, and the largest component
// is positive: equal models give equal shapes.
ModesRecord find_modes(const System& system, const State& state, double time, const ModesSettings& settings);

}  // namespace gxrod
