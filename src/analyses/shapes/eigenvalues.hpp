#pragma once

#include "assembly/lanes/frame_columns.hpp"
#include "model/settings/eigenvalue_settings.hpp"
#include "state/records/eigenvalue_record.hpp"

namespace gxrod {

// Eigenvalues of small motions about the trial motions of a state, with loads at `time`, with damping, loads
// that follow and gyroscopic terms (docs/theory/vibrations.md). Relative to a frame that turns, if the state
// turns with one.
EigenvaluesRecord find_eigenvalues(const System& system,
                                   const State& state,
                                   double time,
                                   const EigenvalueSettings& settings,
                                   const FrameColumns* frame = nullptr);
// The same of matrices that are known.
EigenvaluesRecord find_eigenvalues(const System& system,
                                   const State& state,
                                   double time,
                                   const EigenvalueSettings& settings,
                                   const StateMatrices& matrices);

}  // namespace gxrod
