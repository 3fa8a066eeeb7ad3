#include "tools/node_paths.hpp"

#include "rotation/rates.hpp"
#include "rotation/rotation_map.hpp"
#include "state/increment.hpp"
#include "tools/random_values.hpp"

namespace gxrod::tools {

NodeMotion move(const NodeMotion& previous, const NodeMotion& motion, const Vec6& direction, double amount) {
    NodeMotion moved = motion;
    apply_spin(previous, amount * direction.head<3>(), amount * direction.tail<3>(), moved);
    return moved;
}

NodeMotion follow(const NodeMotion& previous,
                  const NodeMotion& motion,
                  const NodeLinearization& linearization,
                  const Vec6& direction,
                  double amount) {
    NodeMotion moved = move(previous, motion, direction, linearization.placement * amount);
    const Vec3 delta_r = amount * direction.head<3>();
    const Vec3 delta_phi = amount * direction.tail<3>();
    moved.v += linearization.rate * delta_r;
    moved.a += linearization.acceleration * delta_r;
    moved.omega += linearization.d_omega * delta_phi;
    moved.alpha += linearization.d_alpha * delta_phi;
    return moved;
}

std::vector<std::pair<std::string, NodeLinearization>> make_linearizations(unsigned seed) {
    RandomValues random(seed);
    NodeLinearization placement, rate, acceleration, d_omega, d_alpha;
    placement.placement = 1.0;
    rate.rate = 1.7;
    acceleration.acceleration = 2.3;
    d_omega.d_omega = random.matrix<3>();
    d_alpha.d_alpha = random.matrix<3>();
    return {{"placement", placement},
            {"rate", rate},
            {"acceleration", acceleration},
            {"d_omega", d_omega},
            {"d_alpha", d_alpha},
            {"all", {1.0, 1.7, 2.3, random.matrix<3>(), random.matrix<3>()}}};
}

NodeMotion SmoothMotion::at(double t) const {
    NodeMotion motion = start;
    motion.r = start.r + t * start.v + 0.5 * t * t * start.a + t * t * t / 6.0 * r_jerk;
    motion.v = start.v + t * start.a + 0.5 * t * t * r_jerk;
    motion.a = start.a + t * r_jerk;
    const Vec3 phi = t * theta_dot + 0.5 * t * t * theta_ddot + t * t * t / 6.0 * theta_jerk;
    const Vec3 phi_dot = theta_dot + t * theta_ddot + 0.5 * t * t * theta_jerk;
    motion.Lambda = exp_quaternion(phi) * start.Lambda;
    motion.omega = angular_velocity(phi, phi_dot);
    motion.alpha = angular_acceleration(phi, phi_dot, theta_ddot + t * theta_jerk);
    return motion;
}

}  // namespace gxrod::tools
