#pragma once

#include "analyses/path/path_search.hpp"

namespace gxrod {

// The start of a branch at a simple bifurcation of a path, to one side.
struct BranchStart {
    State state;  // at the bifurcation, committed
    double load_scale = 1.0;
    PathVector direction;    // direction of the path at the bifurcation
    Eigen::VectorXd shape;   // the kernel; the branch leaves along it, to the side of this sign
    double softening = 0.0;  // as in LocatedPoint
    std::size_t point = 0;   // index of the path's critical point
    int side = 1;
    double first_step = 0.0;  // length that was found to reach the branch
};

// Finds the first equilibrium of a branch from work.state, the bifurcation. Its amplitude along the shape is
// `step`, which must be short, and the reduced equation gives the prediction. Returns nullopt if there is
// none.
std::optional<PathTrial> step_on_branch(PathContext& work, const BranchStart& start, double step);

}  // namespace gxrod
