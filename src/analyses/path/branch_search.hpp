#pragma once

#include "analyses/path/branch_switch.hpp"
#include "analyses/path/critical_points.hpp"

namespace gxrod {

// The branches that leave a path at a simple bifurcation.
struct FoundBranches {
    std::vector<BranchStart> starts;  // starts to both sides, where equilibria were found
    Branching branching = Branching::unknown;
};

// Finds the branches at the bifurcation in the trial motions of `work`; the workspace has its residual
// afterwards. `pivots_before` are the pivots of the path before it; `settings` bound the first steps.
FoundBranches find_branches(PathContext& work,
                            const LocatedPoint& located,
                            std::int64_t pivots_before,
                            const PathSettings& settings);

}  // namespace gxrod
