#pragma once

#include "assembly/system.hpp"

namespace gxrod {

// Adds to the increments of nodes by how much moving supports will shift and turn theirs, from the trial
// motions to where they are at `time`. The trial motions stay.
void add_support_motion(const System& system, double time, State& state, std::vector<Vec6>& deltas);

// What moving the supports to `time` does to the residual of the trial motions, whose loads are at
// `time_of_loads`, to first order: `part` of it, times 1/part. A difference is as good as any for a guess.
// Forces of contact are left out. `values` are the tangent's.
Eigen::VectorXd compute_support_motion_force(const System& system,
                                             double time,
                                             double time_of_loads,
                                             double part,
                                             const Residual& residual,
                                             const std::vector<double>& values,
                                             const State& state);

}  // namespace gxrod
