#pragma once

#include "assembly/lanes/frame_columns.hpp"
#include "model/settings/eigenvalue_settings.hpp"
#include "state/records/eigenvalue_record.hpp"

namespace gxrod {

// Finds eigenvalues of small motions about the trial motions of a state, with loads at `time`, with damping,
// follower loads and gyroscopic terms (docs/theory/vibrations.md). If the state turns with a frame, motions
// are relative to it.
EigenvaluesRecord find_eigenvalues(const System& system,
                                   const State& state,
                                   double time,
                                   const EigenvalueSettings& settings,
                                   const FrameColumns* frame = nullptr);
// Finds them from given matrices.
EigenvaluesRecord find_eigenvalues(const System& system,
                                   const State& state,
                                   double time,
                                   const EigenvalueSettings& settings,
                                   const StateMatrices& matrices);

}  // namespace gxrod
