#pragma once

#include "assembly/system.hpp"

namespace gxrod {

// Adds to the increments of nodes the displacements and turns by which supports move them from the trial
// motions to their places at `time`. The trial motions stay.
void add_support_motion(const System& system, double time, State& state, std::vector<Vec6>& deltas);

// Computes, to first order, the change of the residual of the trial motions, with loads at `time_of_loads`,
// as supports move to `time`: the change by `part` of the move, times 1/part. A difference is exact enough
// for a guess. Forces of contact are left out. `values` are the tangent's.
Eigen::VectorXd compute_support_motion_force(const System& system,
                                             double time,
                                             double time_of_loads,
                                             double part,
                                             const Residual& residual,
                                             const std::vector<double>& values,
                                             const State& state);

}  // namespace gxrod
