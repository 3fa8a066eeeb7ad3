#pragma once

#include "analyses/path/branch_switch.hpp"
#include "analyses/path/critical_points.hpp"

namespace gxrod {

// The branches that leave a path at a simple bifurcation.
struct FoundBranches {
    std::vector<BranchStart> starts;  // to both sides, where equilibria were found
    Branching branching = Branching::unknown;
};

// The trial motions of `work` hold the bifurcation, and the workspace its residual afterwards.
// `pivots_before` are those of the path before it; `settings` say how long first steps can be.
FoundBranches find_branches(PathContext& work,
                            const LocatedPoint& located,
                            std::int64_t pivots_before,
                            const PathSettings& settings);

}  // namespace gxrod
