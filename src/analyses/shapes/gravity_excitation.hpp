#pragma once

#include "assembly/lanes/frame_columns.hpp"
#include "state/records/response_record.hpp"

namespace gxrod {

// A force and a moment on each node that swing once a revolution, Re(f exp(iωt)) with ω = |Ω|.
struct RevolvingLoad {
    double omega = 0.0;
    ComplexVectors forces;
};

// Computes what gravity that is fixed in space does in a frame that turns, about the trial motions of a
// state: the part of `gravity` across the axis, which has its direction of space at time 0 and turns back in
// the frame (docs/theory/vibrations.md, (V24)).
RevolvingLoad compute_gravity_excitation(
    const System& system, const State& state, double time, const TurningFrame& frame, const Vec3& gravity);

}  // namespace gxrod
