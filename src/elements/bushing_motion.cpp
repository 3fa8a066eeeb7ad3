#include "elements/bushing_motion.hpp"

namespace gxrod {

BushingMotion compute_bushing_motion(const Bushing& bushing, const NodeMotion* a, const NodeMotion* b) {
    const NodeMotion ground;
    const NodeMotion& at_A = a == nullptr ? ground : *a;
    const NodeMotion& at_B = b == nullptr ? ground : *b;
    const Quat axes_of_A = at_A.Lambda * bushing.axes;
    BushingMotion motion;
    motion.distance = compute_distance(bushing.ends, a, b);
    motion.turn = split_rotation(axes_of_A.conjugate() * (at_B.Lambda * bushing.axes));
    motion.axes = (axes_of_A * motion.turn.half).toRotationMatrix();
    motion.turn_rate = at_B.omega - at_A.omega;
    const Vec3 tau = motion.axes * motion.turn.tau;
    motion.middle_spin = 0.5 * (at_A.omega + at_B.omega - tau.cross(motion.turn_rate));
    const Vec3& d = motion.distance.d;
    motion.strain << motion.axes.transpose() * d, motion.turn.Phi;
    motion.rate << motion.axes.transpose() * (motion.distance.rate - motion.middle_spin.cross(d)),
        take_to_rotation_vector(motion.turn, motion.axes.transpose() * motion.turn_rate);
    return motion;
}

Vec3 take_to_rotation_vector(const HalfRotation<double>& turn, const Vec3& v) {
    return turn.x * v + turn.y * turn.Phi.dot(v) * turn.Phi;
}

Vec6 compute_bushing_force(const Bushing& bushing, const BushingMotion& motion) {
    return bushing.stiffness * motion.strain + bushing.damping * motion.rate;
}

}  // namespace gxrod
