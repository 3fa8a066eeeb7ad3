#include "elements/rigid_inertia.hpp"

#include "elements/rotary_inertia.hpp"
#include "rotation/rotation_map.hpp"

namespace gxrod {

namespace {

struct SpatialInertia {
    Vec3 s;
    RotaryInertia<double> rotary;
};

SpatialInertia turn(const RigidInertia& body, const NodeMotion& motion) {
    return {motion.Lambda * body.first_moment, {body.inertia, motion.Lambda}};
}

// J ω, without J.
Vec3 compute_spin_momentum(const RigidInertia& body, const NodeMotion& motion) {
    return motion.Lambda * (body.inertia * (motion.Lambda.conjugate() * motion.omega));
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
    const auto [s, rotary] = turn(body, motion);
    const Vec3 a = motion.a - gravity;
    const Vec3& omega = motion.omega;
    Vec6 force;
    force << body.mass * a + motion.alpha.cross(s) + omega.cross(omega.cross(s)),
        rotary.compute_moment(omega, motion.alpha) + s.cross(a);
    return force;
}

Mat6 compute_inertial_tangent(const RigidInertia& body,
                              const NodeMotion& motion,
                              const NodeLinearization& linearization,
                              const Vec3& gravity) {
    const auto [s, rotary] = turn(body, motion);
    const Mat3 spin_s = spin(s);
    const Mat3 spin_omega = spin(motion.omega);
    const Mat3 spin_alpha = spin(motion.alpha);
    Mat6 tangent;
    tangent.topLeftCorner<3, 3>() = Mat3::Identity() * (body.mass * linearization.acceleration);
    tangent.bottomLeftCorner<3, 3>() = spin_s * linearization.acceleration;
    tangent.topRightCorner<3, 3>() =
        -spin_s * linearization.d_alpha -
        (spin(motion.omega.cross(s)) + spin_omega * spin_s) * linearization.d_omega -
        linearization.placement * (spin_alpha + spin_omega * spin_omega) * spin_s;
    tangent.bottomRightCorner<3, 3>() = rotary.compute_tangent(motion.omega,
                                                               motion.alpha,
                                                               linearization.placement,
                                                               linearization.d_omega,
                                                               linearization.d_alpha) +
                                        linearization.placement * spin(motion.a - gravity) * spin_s;
    return tangent;
}

double compute_kinetic_energy(const RigidInertia& body, const NodeMotion& motion) {
    const Vec3 s = motion.Lambda * body.first_moment;
    return 0.5 * body.mass * motion.v.squaredNorm() + motion.v.dot(motion.omega.cross(s)) +
           0.5 * motion.omega.dot(compute_spin_momentum(body, motion));
}

Momentum compute_momentum(const RigidInertia& body, const NodeMotion& motion) {
    const Vec3 s = motion.Lambda * body.first_moment;
    const Vec3 linear = body.mass * motion.v + motion.omega.cross(s);
    return {linear, motion.r.cross(linear) + s.cross(motion.v) + compute_spin_momentum(body, motion)};
}

double compute_gravity_potential(const RigidInertia& body, const NodeMotion& motion, const Vec3& gravity) {
    return -gravity.dot(body.mass * motion.r + motion.Lambda * body.first_moment);
}

}  // namespace gxrod
