#pragma once

#include "analyses/path/path_search.hpp"

namespace gxrod {

// From where and where to a branch leaves a path: at a simple bifurcation, to one side.
struct BranchStart {
    State state;  // at the bifurcation, committed
    double load_scale = 1.0;
    PathVector direction;    // of the path that it leaves
    Eigen::VectorXd shape;   // the kernel; the branch leaves along it, to the side of this sign
    double softening = 0.0;  // of LocatedPoint
    std::size_t point = 0;   // index of the path's critical point
    int side = 1;
    double first_step = 0.0;  // that was found to lead on to it
};

// The first equilibrium of a branch, from work.state, which is that at the bifurcation: at the amplitude
// `step` of the shape, which must be short, where the reduced equation says. nullopt if there is none.
std::optional<PathTrial> step_on_branch(PathContext& work, const BranchStart& start, double step);

}  // namespace gxrod
