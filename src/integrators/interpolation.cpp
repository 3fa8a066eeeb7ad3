#include <algorithm>

#include "integrators/coupled_stages.hpp"
#include "rotation/tangent_map.hpp"
#include "state/increment.hpp"

// Motions between the ends of a step: docs/theory/newmark.md, "Within a step".
namespace gxrod {

namespace {

// The cubic on 0 … 1 that is 0 and `to` at the ends, with these slopes there.
struct Cubic {
    Vec3 to, slope_0, slope_1;

    Vec3 value(double x) const {
        const double y = 1.0 - x;
        return x * x * (3.0 - 2.0 * x) * to + x * y * (y * slope_0 - x * slope_1);
    }
    Vec3 slope(double x) const {
        const double y = 1.0 - x;
        return 6.0 * x * y * to + y * (1.0 - 3.0 * x) * slope_0 + x * (3.0 * x - 2.0) * slope_1;
    }
};

}  // namespace

void Integrator::interpolate(const State& state,
                             double time_step,
                             double fraction,
                             std::vector<NodeMotion>& motions,
                             const ThreadTeam& team) const {
    motions.resize(state.trial.size());
    team.for_each_range(motions.size(), [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            const NodeMotion& from = state.previous[i];
            const NodeMotion& to = state.trial[i];
            const Cubic r{to.r - from.r, time_step * from.v, time_step * to.v};
            const Cubic theta{
                to.theta, time_step * from.omega, time_step * (tangent_map_inverse(to.theta) * to.omega)};
            NodeMotion& motion = motions[i];
            place(from, from.r + r.value(fraction), theta.value(fraction), motion);
            motion.v = r.slope(fraction) / time_step;
            motion.omega = tangent_map(motion.theta) * theta.slope(fraction) / time_step;
            motion.a = from.a + fraction * (to.a - from.a);
            motion.alpha = from.alpha + fraction * (to.alpha - from.alpha);
        }
    });
}

std::vector<double> Integrator::interpolation_weights(double fraction) const {
    std::vector<double> at = inner_fractions();
    at.insert(at.begin(), 0.0);
    at.push_back(1.0);
    std::vector<double> weights(at.size(), 1.0);
    for (std::size_t i = 0; i < at.size(); ++i) {
        for (std::size_t j = 0; j < at.size(); ++j) {
            if (j != i) weights[i] *= (fraction - at[j]) / (at[i] - at[j]);
        }
    }
    return weights;
}

std::vector<double> CoupledStages::inner_fractions() const {
    std::vector<double> fractions(fractions_.begin(), fractions_.end());
    if (ends_with_stage_) fractions.pop_back();
    return fractions;
}

Interpolant CoupledStages::interpolant() const {
    return {"polynomials through the stages and both ends", stage_count() + 1};
}

void CoupledStages::interpolate(const State& state,
                                double /*time_step*/,
                                double fraction,
                                std::vector<NodeMotion>& motions,
                                const ThreadTeam& team) const {
    const std::vector<double> weights = interpolation_weights(fraction);
    motions.resize(state.trial.size());
    team.for_each_range(motions.size(), [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            const NodeMotion& from = state.previous[i];
            NodeMotion& motion = motions[i];
            motion = from;
            Vec3 r = from.r, theta = Vec3::Zero();
            for (std::size_t k = 1; k < weights.size(); ++k) {
                const bool is_end = k + 1 == weights.size();
                const NodeMotion& at = is_end ? state.trial[i] : state.stage_motions[k - 1][i];
                r += weights[k] * (at.r - from.r);
                theta += weights[k] * at.theta;
                motion.v += weights[k] * (at.v - from.v);
                motion.omega += weights[k] * (at.omega - from.omega);
                motion.a += weights[k] * (at.a - from.a);
                motion.alpha += weights[k] * (at.alpha - from.alpha);
            }
            place(from, r, theta, motion);
        }
    });
}

}  // namespace gxrod
