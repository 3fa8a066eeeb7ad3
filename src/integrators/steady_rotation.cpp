#include "integrators/steady_rotation.hpp"

namespace gxrod {

void turn_with(const Vec3& spin, const Vec3& through, NodeMotion& motion) {
    motion.v = spin.cross(motion.r - through);
    motion.a = spin.cross(motion.v);
    motion.omega = spin;
    motion.alpha.setZero();
}

void set_steady_rates(const TurningFrame& frame, double load_factor, std::size_t node, NodeMotion& motion) {
    if (!frame.is_at_rest()) return turn_with(frame.spin(load_factor), frame.through, motion);
    motion.v.setZero();
    motion.a.setZero();
    motion.omega = frame.spin_of(node, motion.Lambda, load_factor);
    motion.alpha.setZero();
}

void SteadyRotation::place_nodes(State& state, const Stage& stage, NodeRange nodes) const {
    LoadStepping::place_nodes(state, stage, nodes);
    update_nodes(state, stage, nodes);
}

void SteadyRotation::update_nodes(State& state, const Stage& stage, NodeRange nodes) const {
    const double load_factor = stage_time(stage);
    for (std::size_t i = nodes.first; i < nodes.last; ++i)
        set_steady_rates(frame_, load_factor, i, state.trial[i]);
}

}  // namespace gxrod
