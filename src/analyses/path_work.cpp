#include "analyses/path_work.hpp"

#include <algorithm>
#include <cmath>

#include "rotation/rotation_map.hpp"

namespace gxrod {

namespace {

// What nodes and joints do between two points.
LoadStep compute_load_step(const PathPoint& from, const PathPoint& to) {
    LoadStep step{to.forces, std::vector<Vec6>(to.forces.size()), to.load_factor - from.load_factor};
    const std::size_t nodes = to.turned.size();
    for (std::size_t i = 0; i < to.coordinates.size(); ++i) {
        step.force_change[nodes + i] -= from.forces[nodes + i];
        step.movement[nodes + i] = to.coordinates[i] - from.coordinates[i];
    }
    for (std::size_t i = 0; i < nodes; ++i) {
        const NodeMotion& a = from.state.trial[i];
        const NodeMotion& b = to.state.trial[i];
        step.force_change[i] -= from.forces[i];
        step.movement[i] << b.r - a.r,
            log_nearest(b.Lambda * a.Lambda.conjugate(), to.turned[i] - from.turned[i]);
    }
    return step;
}

// Half-way, or else where an equilibrium can be found.
std::optional<PathPoint> find_between(const PathPoint& from, const PathPoint& to, const PathSearch& search) {
    for (const double part : {0.5, 0.25, 0.75, 0.125}) {
        std::optional<PathPoint> found =
            search.find(from, from.load_factor + part * (to.load_factor - from.load_factor));
        if (found) return found;
    }
    return std::nullopt;
}

}  // namespace

StepWork integrate_path(const PathPoint& from, const PathPoint& to, const PathSearch& search) {
    StepWork whole = compute_step_work(from.forces, compute_load_step(from, to), {});
    const double imbalance = std::abs(to.strain_energy - from.strain_energy - whole.work);
    // Where work and strain energy agree, there is no uncertainty.
    whole.uncertainty = std::min(whole.uncertainty, imbalance);
    const bool is_hard = to.iterations >= many_iterations;
    if ((imbalance <= search.tolerable && !is_hard) || search.halvings == 0) return whole;
    const std::optional<PathPoint> middle = find_between(from, to, search);
    if (!middle) return whole;
    const PathSearch finer{search.find, search.tolerable, search.halvings - 1};
    PathPoint end = to;
    if (is_hard) {
        const std::optional<PathPoint> again = search.find(*middle, to.load_factor);
        end.iterations = again ? again->iterations : many_iterations;
    }
    const StepWork first = integrate_path(from, *middle, finer);
    const StepWork second = integrate_path(*middle, end, finer);
    return {first.work + second.work, first.uncertainty + second.uncertainty};
}

}  // namespace gxrod
