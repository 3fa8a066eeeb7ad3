// Every frame of nodal load: its value on a turned node, its derivative, its work.

#include "loads/nodal_load.hpp"
#include "state/increment.hpp"
#include "tools/catch.hpp"
#include "tools/difference.hpp"
#include "tools/random_values.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

const Vec3 force(2.0, -1.0, 0.5);
const Vec3 moment(0.3, 0.7, -1.1);

// Force and moment grow as t and t².
NodalLoad make_load(Frame frame) {
    NodalLoad load;
    load.frame = frame;
    load.axes = RandomValues(61).rotation();
    for (int i = 0; i < 3; ++i) {
        load.force[i] = TimeFunction([i](double t) { return t * force[i]; });
        load.moment[i] = TimeFunction([i](double t) { return t * t * moment[i]; });
    }
    return load;
}

NodeMotion make_motion() {
    RandomValues random(62);
    NodeMotion motion;
    place({}, random.vector(), random.vector(1.5), motion);
    return motion;
}

const std::vector<std::pair<std::string, Frame>> frames{
    {"dead", Frame::spatial}, {"follower", Frame::follower}, {"body", Frame::body}};

Vec6 stack(const Vec3& first, const Vec3& second) {
    Vec6 stacked;
    stacked << first, second;
    return stacked;
}

}  // namespace

TEST_CASE("loads stand in the frame that they name", "[loads]") {
    const NodeMotion motion = make_motion();
    const Quat& Lambda = motion.Lambda;
    const double t = 1.7;
    const Vec3 f = t * force;
    const Vec3 m = t * t * moment;
    CHECK(relative_difference(compute_load(make_load(Frame::spatial), motion, t), stack(f, m)) < 1e-15);
    CHECK(relative_difference(compute_load(make_load(Frame::follower), motion, t),
                              stack(Lambda * f, Lambda * m)) < 1e-15);
    const NodalLoad body = make_load(Frame::body);
    const Quat axes = Lambda * body.axes;
    CHECK(relative_difference(compute_load(body, motion, t), stack(axes * f, axes * m)) < 1e-15);
}

TEST_CASE("at the start a follower load has its global components", "[loads]") {
    const Vec6 expected = stack(force, moment);
    CHECK(relative_difference(compute_load(make_load(Frame::follower), NodeMotion{}, 1.0), expected) < 1e-15);
    CHECK(relative_difference(compute_load(make_load(Frame::spatial), NodeMotion{}, 1.0), expected) < 1e-15);
}

TEST_CASE("constant components need no function", "[loads]") {
    NodalLoad load;
    load.force = {1.0, 2.0, 3.0};
    load.moment = {4.0, 5.0, 6.0};
    CHECK(compute_load(load, make_motion(), 0.3) == stack(Vec3(1.0, 2.0, 3.0), Vec3(4.0, 5.0, 6.0)));
}

TEST_CASE("load tangents are derivatives of loads", "[loads]") {
    const NodeMotion motion = make_motion();
    for (const auto& [name, frame] : frames) {
        INFO(name);
        const NodalLoad load = make_load(frame);
        Mat6 expected;
        for (int unknown = 0; unknown < 6; ++unknown) {
            expected.col(unknown) = differentiate([&](double amount) {
                const Vec6 step = amount * Vec6::Unit(unknown);
                NodeMotion moved = motion;
                apply_spin({}, step.head<3>(), step.tail<3>(), moved);
                return compute_load(load, moved, 1.7);
            });
        }
        const Vec6 value = compute_load(load, motion, 1.7);
        NodeLinearization linearization;
        linearization.placement = 1.0;
        CHECK(relative_difference(compute_load_tangent(load, value, linearization), expected) < 1e-9);
        // Rates and accelerations push nothing.
        linearization = {0.0, 1.0, 1.0, Mat3::Ones(), Mat3::Ones()};
        CHECK(compute_load_tangent(load, value, linearization).isZero());
    }
}

TEST_CASE("follower and body loads keep their components in the turning axes", "[loads]") {
    // So their power against material velocities does not depend on the rotation.
    const Vec3 v(0.4, -0.3, 0.8);
    const Vec3 omega(1.0, 0.2, -0.6);
    RandomValues random(63);
    for (int i = 0; i < 5; ++i) {
        NodeMotion motion;
        motion.Lambda = random.rotation();
        const Vec6 value = compute_load(make_load(Frame::follower), motion, 1.0);
        const double power =
            value.head<3>().dot(motion.Lambda * v) + value.tail<3>().dot(motion.Lambda * omega);
        CHECK(power == Approx(force.dot(v) + moment.dot(omega)).epsilon(1e-14));
    }
}
