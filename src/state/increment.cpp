#include "state/increment.hpp"

#include "rotation/rotation_map.hpp"
#include "rotation/tangent_map.hpp"

namespace gxrod {

void apply_spin(const NodeMotion& previous, const Vec3& delta_r, const Vec3& delta_phi, NodeMotion& trial) {
    trial.r += delta_r;
    const Vec3 guess = trial.theta + tangent_map_inverse(trial.theta) * delta_phi;
    // Composed from θ rather than from Λ Λₙᵀ, a small rotation keeps its relative accuracy; rates divide it
    // by Δt².
    const Quat step = (exp_quaternion(delta_phi) * exp_quaternion(trial.theta)).normalized();
    trial.theta = log_nearest(step, guess);
    trial.Lambda = (step * previous.Lambda).normalized();
}

void place(const NodeMotion& previous, const Vec3& r, const Vec3& theta, NodeMotion& trial) {
    trial.r = r;
    trial.theta = theta;
    trial.Lambda = (exp_quaternion(theta) * previous.Lambda).normalized();
}

}  // namespace gxrod
