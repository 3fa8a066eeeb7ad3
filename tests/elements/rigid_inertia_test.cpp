#include "elements/rigid_inertia.hpp"

#include "tools/catch.hpp"
#include "tools/difference.hpp"
#include "tools/random_values.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

// A body as a cloud of point masses, so that the formulas are checked against sums of m a.
struct Particle {
    double mass;
    Vec3 place;  // in body axes, from the node
};

std::vector<Particle> make_cloud() {
    RandomValues random(8);
    std::vector<Particle> cloud;
    for (int i = 0; i < 7; ++i) cloud.push_back({random.number(0.1, 1.0), random.vector()});
    return cloud;
}

RigidInertia compute_inertia(const std::vector<Particle>& cloud, const Quat& axes) {
    double mass = 0.0;
    Vec3 first_moment = Vec3::Zero();
    for (const Particle& particle : cloud) {
        mass += particle.mass;
        first_moment += particle.mass * particle.place;
    }
    const Vec3 centre = first_moment / mass;
    Mat3 inertia = Mat3::Zero();
    for (const Particle& particle : cloud) {
        const Mat3 arm = spin(particle.place - centre);
        inertia -= particle.mass * arm * arm;
    }
    return compute_rigid_inertia(mass, inertia, centre, axes);
}

NodeMotion make_motion() {
    RandomValues random(9);
    return {random.vector(),
            random.rotation(),
            Vec3::Zero(),
            random.vector(),
            random.vector(),
            random.vector(),
            random.vector()};
}

}  // namespace

TEST_CASE("a body's inertia is that of its particles", "[elements]") {
    const Vec3 gravity(0.2, -0.4, -9.81);
    const auto cloud = make_cloud();
    const Quat axes = RandomValues(10).rotation();
    const RigidInertia body = compute_inertia(cloud, axes);
    const NodeMotion motion = make_motion();
    Vec6 force = Vec6::Zero();
    double energy = 0.0;
    double potential = 0.0;
    Momentum momentum;
    for (const Particle& particle : cloud) {
        const Vec3 arm = motion.Lambda * (axes * particle.place);
        const Vec3 velocity = motion.v + motion.omega.cross(arm);
        const Vec3 acceleration =
            motion.a + motion.alpha.cross(arm) + motion.omega.cross(motion.omega.cross(arm));
        const Vec3 push = particle.mass * (acceleration - gravity);
        force.head<3>() += push;
        force.tail<3>() += arm.cross(push);
        energy += 0.5 * particle.mass * velocity.squaredNorm();
        potential -= particle.mass * gravity.dot(motion.r + arm);
        momentum.linear += particle.mass * velocity;
        momentum.angular += particle.mass * (motion.r + arm).cross(velocity);
    }
    CHECK(relative_difference(compute_inertial_force(body, motion, gravity), force) < 1e-14);
    CHECK(relative_difference(compute_kinetic_energy(body, motion), energy) < 1e-14);
    CHECK(relative_difference(compute_gravity_potential(body, motion, gravity), potential) < 1e-14);
    CHECK(relative_difference(compute_momentum(body, motion).linear, momentum.linear) < 1e-14);
    CHECK(relative_difference(compute_momentum(body, motion).angular, momentum.angular) < 1e-14);
}

TEST_CASE("the tangent of a central body is (5.6)", "[elements]") {
    RandomValues random(12);
    const Mat3 inertia = random.positive_definite<3>();
    const RigidInertia body = compute_rigid_inertia(2.0, inertia, Vec3::Zero(), Quat::Identity());
    const NodeMotion motion = make_motion();
    const double beta = 0.25;
    const double gamma = 0.5;
    const double dt = 0.1;
    NodeLinearization paper{1.0, gamma / (beta * dt), 1.0 / (beta * dt * dt), Mat3::Zero(), Mat3::Zero()};
    paper.d_omega = paper.rate * Mat3::Identity();
    paper.d_alpha = paper.acceleration * Mat3::Identity();
    const Mat3 R = motion.Lambda.toRotationMatrix();
    const Mat3 J = R * inertia * R.transpose();
    const Vec3& omega = motion.omega;
    const Mat3 A =
        -spin(J * motion.alpha) + J * spin(motion.alpha) + spin(omega) * (-spin(J * omega) + J * spin(omega));
    const Mat3 K = A + J / (beta * dt * dt) + gamma / (beta * dt) * (-spin(J * omega) + spin(omega) * J);
    const Mat6 tangent = compute_inertial_tangent(body, motion, paper, Vec3::Zero());
    CHECK(relative_difference(tangent.bottomRightCorner<3, 3>(), K) < 1e-14);
    CHECK(tangent.topRightCorner<3, 3>().isZero());
    CHECK(tangent.bottomLeftCorner<3, 3>().isZero());
}
