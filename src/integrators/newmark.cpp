#include "integrators/newmark.hpp"

#include "state/increment.hpp"

namespace gxrod {

void update_translation(const Newmark& newmark,
                        const NodeMotion& previous,
                        double time_step,
                        NodeMotion& trial) {
    const Vec3 w = (trial.r - previous.r) / time_step;
    trial.a = newmark.acceleration(w, previous.v, previous.a, time_step);
    trial.v = newmark.velocity(previous.v, previous.a, trial.a, time_step);
}

void predict_constant_acceleration(State& state, double h, NodeRange nodes) {
    for (std::size_t i = nodes.first; i < nodes.last; ++i) {
        const NodeMotion& previous = state.previous[i];
        place(previous,
              previous.r + h * previous.v + (0.5 * h * h) * previous.a,
              h * previous.omega + (0.5 * h * h) * previous.alpha,
              state.trial[i]);
    }
}

}  // namespace gxrod
