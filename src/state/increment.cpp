#include "state/increment.hpp"

#include "rotation/rotation_map.hpp"
#include "rotation/tangent_map.hpp"

namespace gxrod {

void apply_spin(const NodeMotion& previous, const Vec3& delta_r, const Vec3& delta_phi, NodeMotion& trial) {
    trial.r += delta_r;
    const Vec3 guess = trial.theta + tangent_map_inverse(trial.theta) * delta_phi;
    trial.Lambda = (exp_quaternion(delta_phi) * trial.Lambda).normalized();
    trial.theta = log_nearest(trial.Lambda * previous.Lambda.conjugate(), guess);
}

void place(const NodeMotion& previous, const Vec3& r, const Vec3& theta, NodeMotion& trial) {
    trial.r = r;
    trial.theta = theta;
    trial.Lambda = (exp_quaternion(theta) * previous.Lambda).normalized();
}

}  // namespace gxrod
