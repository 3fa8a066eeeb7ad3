#include "analyses/path/branch_search.hpp"

#include <cmath>

namespace gxrod {

namespace {

// Sets the first step; returns the change of the load factor in it, or nullopt if none leads to the branch.
std::optional<double> find_first_step(PathContext& work, const PathSettings& settings, BranchStart& start) {
    for (double step = 0.1 * settings.max_step; step > settings.min_step; step *= 0.25) {
        State trial = start.state;
        PathContext search{
            work.system, work.integrator, work.newton, work.metric, work.is_symmetric, work.workspace, trial};
        const std::optional<PathTrial> found = step_on_branch(search, start, step);
        if (!found || work.metric.multiply(found->direction, {start.side * start.shape, 0.0}) <
                          std::cos(widest_path_angle))
            continue;
        start.first_step = step;
        return found->load_factor - start.state.time;
    }
    return std::nullopt;
}

Branching classify(double rise, double rise_of_other_side, const PathTrial& at, std::int64_t pivots_before) {
    if ((rise > 0.0) != (rise_of_other_side > 0.0)) return Branching::transcritical;
    const bool gets_unstable = at.pivots > pivots_before;
    const bool goes_with_path = (rise > 0.0) == (at.direction.load > 0.0);
    return gets_unstable == goes_with_path ? Branching::supercritical : Branching::subcritical;
}

}  // namespace

FoundBranches find_branches(PathContext& work,
                            const LocatedPoint& located,
                            std::int64_t pivots_before,
                            const PathSettings& settings) {
    State at = work.state;
    work.system.commit(at, located.trial.load_factor);
    FoundBranches found;
    std::vector<double> rises;
    for (const int side : {1, -1}) {
        BranchStart start{at,
                          work.metric.load_scale(),
                          located.trial.direction,
                          located.kernel.col(0),
                          located.softening,
                          0,
                          side,
                          0.0};
        const std::optional<double> rise = find_first_step(work, settings, start);
        if (!rise) continue;
        rises.push_back(*rise);
        found.starts.push_back(std::move(start));
    }
    work.system.compute_residual(work.state, located.trial.load_factor, work.workspace.residual);
    if (rises.size() == 2) found.branching = classify(rises[0], rises[1], located.trial, pivots_before);
    return found;
}

}  // namespace gxrod
