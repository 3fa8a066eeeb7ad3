#pragma once

#include "assembly/lanes/frame_columns.hpp"
#include "state/records/response_record.hpp"

namespace gxrod {

// Computes the steady answers (K + iω D − ω² M + Σ iωτ/(1 + iωτ) R) u = f to the force and moment f on each
// node at each ω, about the trial motions of a state, with loads at `time`. If the state turns with a frame,
// motions are relative to it.
ResponseRecord find_response(const System& system,
                             const State& state,
                             double time,
                             const std::vector<double>& omegas,
                             const ComplexVectors& excitation,
                             const FrameColumns* frame = nullptr);

}  // namespace gxrod
