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

}  // namespace

StepWork integrate_path(const PathPoint& from, const PathPoint& to, const PathSearch& search) {
    StepWork whole = compute_step_work(from.forces, compute_load_step(from, to), {});
    const double imbalance = std::abs(to.strain_energy - from.strain_energy - whole.work);
    // Where work and strain energy agree, there is no uncertainty.
    whole.uncertainty = std::min(whole.uncertainty, imbalance);
    if (imbalance <= search.tolerable || search.halvings == 0) return whole;
    const std::optional<PathPoint> middle =
        search.find(from, from.load_factor + 0.5 * (to.load_factor - from.load_factor));
    if (!middle) return whole;
    const PathSearch finer{search.find, search.tolerable, search.halvings - 1};
    const StepWork first = integrate_path(from, *middle, finer);
    const StepWork second = integrate_path(*middle, to, finer);
    return {first.work + second.work, first.uncertainty + second.uncertainty};
}

}  // namespace gxrod
