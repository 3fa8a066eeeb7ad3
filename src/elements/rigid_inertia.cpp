#include "elements/rigid_inertia.hpp"

#include "rotation/rotation_map.hpp"

namespace gxrod {

namespace {

struct SpatialInertia {
    Vec3 s;
    Mat3 J;
};

SpatialInertia turn(const RigidInertia& body, const NodeMotion& motion) {
    const Mat3 Lambda = motion.Lambda.toRotationMatrix();
    return {Lambda * body.first_moment, Lambda * body.inertia * Lambda.transpose()};
}

}  // namespace

RigidInertia compute_rigid_inertia(double mass,
                                   const Mat3& inertia,
                                   const Vec3& centre_of_mass,
                                   const Quat& axes) {
    const Mat3 R = axes.toRotationMatrix();
    const Mat3 offset = spin(centre_of_mass);
    return {mass, mass * (R * centre_of_mass), R * (inertia - mass * offset * offset) * R.transpose()};
}

Vec6 compute_inertial_force(const RigidInertia& body, const NodeMotion& motion, const Vec3& gravity) {
    const auto [s, J] = turn(body, motion);
    const Vec3 a = motion.a - gravity;
    const Vec3& omega = motion.omega;
    Vec6 force;
    force << body.mass * a + motion.alpha.cross(s) + omega.cross(omega.cross(s)),
        J * motion.alpha + omega.cross(J * omega) + s.cross(a);
    return force;
}

Mat6 compute_inertial_tangent(const RigidInertia& body,
                              const NodeMotion& motion,
                              const NodeLinearization& linearization,
                              const Vec3& gravity) {
    const auto [s, J] = turn(body, motion);
    const Mat3 spin_s = spin(s);
    const Mat3 spin_omega = spin(motion.omega);
    const Mat3 spin_alpha = spin(motion.alpha);
    const Mat3 gyroscopic = -spin(J * motion.omega) + spin_omega * J;
    // What turning the body does to its inertial moment: A of (5.6).
    const Mat3 A = -spin(J * motion.alpha) + J * spin_alpha +
                   spin_omega * (-spin(J * motion.omega) + J * spin_omega) +
                   spin(motion.a - gravity) * spin_s;
    Mat6 tangent;
    tangent.topLeftCorner<3, 3>() = Mat3::Identity() * (body.mass * linearization.acceleration);
    tangent.bottomLeftCorner<3, 3>() = spin_s * linearization.acceleration;
    tangent.topRightCorner<3, 3>() =
        -spin_s * linearization.d_alpha -
        (spin(motion.omega.cross(s)) + spin_omega * spin_s) * linearization.d_omega -
        linearization.placement * (spin_alpha + spin_omega * spin_omega) * spin_s;
    tangent.bottomRightCorner<3, 3>() =
        J * linearization.d_alpha + gyroscopic * linearization.d_omega + linearization.placement * A;
    return tangent;
}

double compute_kinetic_energy(const RigidInertia& body, const NodeMotion& motion) {
    const auto [s, J] = turn(body, motion);
    return 0.5 * body.mass * motion.v.squaredNorm() + motion.v.dot(motion.omega.cross(s)) +
           0.5 * motion.omega.dot(J * motion.omega);
}

Momentum compute_momentum(const RigidInertia& body, const NodeMotion& motion) {
    const auto [s, J] = turn(body, motion);
    const Vec3 linear = body.mass * motion.v + motion.omega.cross(s);
    return {linear, motion.r.cross(linear) + s.cross(motion.v) + J * motion.omega};
}

double compute_gravity_potential(const RigidInertia& body, const NodeMotion& motion, const Vec3& gravity) {
    return -gravity.dot(body.mass * motion.r + motion.Lambda * body.first_moment);
}

}  // namespace gxrod
