#include "integrators/runge_kutta_4.hpp"

#include "integrators/scheme_samples.hpp"
#include "rotation/rotation_map.hpp"
#include "tools/catch.hpp"
#include "tools/difference.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

constexpr double dt = 0.2;

// Accelerations as functions of time and motion, to stand for a model.
Vec3 a_of(double t, const NodeMotion& motion) { return Vec3(std::sin(t), motion.v.x(), -motion.r.z()); }
Vec3 alpha_of(double t, const NodeMotion& motion) {
    return motion.omega.cross(Vec3(1.0, 2.0, 3.0)) + std::cos(t) * (motion.Lambda * Vec3::UnitX());
}

using Full = Eigen::Matrix<double, 13, 1>;  // r, q (x y z w), v, ω

Full pack(const NodeMotion& motion) {
    Full y;
    y << motion.r, motion.Lambda.coeffs(), motion.v, motion.omega;
    return y;
}

// The right-hand side as a textbook has it, the rotation of the loads normalised.
Full compute_rate(double t, const Full& y) {
    NodeMotion motion;
    const Quat q(Eigen::Vector4d(y.segment<4>(3)));
    motion.r = y.head<3>();
    motion.Lambda = q.normalized();
    motion.v = y.segment<3>(7);
    motion.omega = y.tail<3>();
    const Quat omega(0.0, motion.omega.x(), motion.omega.y(), motion.omega.z());
    Full rate;
    rate << motion.v, 0.5 * (omega * q).coeffs(), a_of(t, motion), alpha_of(t, motion);
    return rate;
}

}  // namespace

TEST_CASE("runge-kutta-4 is the classical scheme on (r, q, v, ω)", "[integrators]") {
    const RungeKutta4 scheme;
    State state = make_random_state(scheme, 95);
    for (NodeMotion& motion : state.previous) {
        motion.a = a_of(0.3, motion);
        motion.alpha = alpha_of(0.3, motion);
    }
    state.trial = state.previous;
    const Full y = pack(state.previous[0]);
    for (int k = 0; k < 4; ++k) {
        const Stage stage = make_stage(k);
        scheme.begin_stage(state, stage);
        for (NodeMotion& motion : state.trial) {
            motion.a = a_of(scheme.stage_time(stage), motion);
            motion.alpha = alpha_of(scheme.stage_time(stage), motion);
        }
        scheme.end_stage(state, stage);
    }
    const Full k1 = compute_rate(0.3, y);
    const Full k2 = compute_rate(0.4, y + 0.5 * dt * k1);
    const Full k3 = compute_rate(0.4, y + 0.5 * dt * k2);
    const Full k4 = compute_rate(0.5, y + dt * k3);
    Full expected = y + dt / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
    expected.segment<4>(3).normalize();
    CHECK(relative_difference(pack(state.trial[0]), expected) < 1e-14);
    const Vec3 theta = log(state.trial[0].Lambda * state.previous[0].Lambda.conjugate());
    CHECK(relative_difference(state.trial[0].theta, theta) < 1e-13);
}

TEST_CASE("runge-kutta-4 starts a step from the rates of the last", "[integrators]") {
    const RungeKutta4 scheme;
    State state = make_random_state(scheme, 96);
    state.trial[0].v.setConstant(7.0);  // what an earlier trial left behind
    scheme.begin_stage(state, make_stage(0));
    const NodeMotion& previous = state.previous[0];
    CHECK(relative_difference(state.trial[0].r, previous.r + 0.5 * dt * previous.v) < 1e-15);
    CHECK(relative_difference(state.trial[0].v, previous.v + 0.5 * dt * previous.a) < 1e-15);
    CHECK(relative_difference(state.trial[0].omega, previous.omega + 0.5 * dt * previous.alpha) < 1e-15);
}
