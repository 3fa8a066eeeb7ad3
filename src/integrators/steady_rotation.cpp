#include "integrators/steady_rotation.hpp"

namespace gxrod {

void turn_with(const Vec3& spin, const Vec3& through, NodeMotion& motion) {
    motion.v = spin.cross(motion.r - through);
    motion.a = spin.cross(motion.v);
    motion.omega = spin;
    motion.alpha.setZero();
}

void SteadyRotation::place_nodes(State& state, const Stage& stage, NodeRange nodes) const {
    LoadStepping::place_nodes(state, stage, nodes);
    update_nodes(state, stage, nodes);
}

void SteadyRotation::update_nodes(State& state, const Stage& stage, NodeRange nodes) const {
    const Vec3 spin = frame_.spin(stage_time(stage));
    for (std::size_t i = nodes.first; i < nodes.last; ++i) turn_with(spin, frame_.through, state.trial[i]);
}

}  // namespace gxrod
