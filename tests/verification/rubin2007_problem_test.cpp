#include "verification/rubin2007_problem.hpp"

#include <numbers>

#include "rotation/rotation_map.hpp"
#include "tools/catch.hpp"
#include "tools/difference.hpp"
#include "verification/rubin2007_matrix_rk4.hpp"

using namespace gxrod;
using namespace gxrod::tools;
using namespace gxrod::rubin2007;

namespace {

const std::vector<double> times{0.0, 0.4, 1.3, 2.9, std::numbers::pi, 4.4, 5.8, 6.2};

Mat3 compute_inertia(double t) {
    const Mat3 Lambda = exact_rotation(t);
    return Lambda * Vec3(inertia_1, inertia_1, inertia_3).asDiagonal() * Lambda.transpose();
}

}  // namespace

TEST_CASE("the exact motion of the paper's problem satisfies Euler's equations", "[verification]") {
    for (const double t : times) {
        INFO("t = " << t);
        const Vec3 H_dot = differentiate([&](double dt) { return exact_momentum(t + dt); });
        CHECK((H_dot - moment(t)).norm() < 1e-11);
        const Vec3 omega = exact_angular_velocity(t);
        CHECK((compute_inertia(t) * omega - exact_momentum(t)).norm() < 1e-13);
        const Mat3 Lambda_dot = differentiate([&](double dt) { return exact_rotation(t + dt); }, 1e-3);
        CHECK((Lambda_dot * exact_rotation(t).transpose() - spin(omega)).norm() < 1e-10);
        CHECK(std::abs(exact_kinetic_energy(t) - 0.5 * omega.dot(exact_momentum(t))) < 1e-13);
    }
}

TEST_CASE("the body of the paper's problem starts and ends at rest, upright as it was", "[verification]") {
    const Mat3 start = Eigen::AngleAxisd(std::numbers::pi / 3.0, Vec3::UnitY()).toRotationMatrix();
    CHECK((exact_rotation(0.0) - start).norm() < 1e-15);
    CHECK((exact_rotation(period) - start).norm() < 1e-13);
    CHECK(exact_momentum(0.0).norm() == 0.0);
    CHECK(exact_momentum(period).norm() < 1e-14);
    CHECK(exact_kinetic_energy(period) < 1e-28);
    CHECK(exact_momentum(0.5 * period).z() == Approx(12.0).epsilon(1e-15));
    CHECK(inertia_1 / inertia_3 == Approx(4.0 / 3.0).epsilon(1e-15));
}

TEST_CASE("errors are measured against the exact motion", "[verification]") {
    const double t = 2.0;
    const Errors none = compute_errors(t, exact_rotation(t), exact_momentum(t), exact_kinetic_energy(t));
    CHECK(none.orientation == 0.0);
    CHECK(none.momentum == 0.0);
    CHECK(none.energy == 0.0);
    const Mat3 turned = exp_matrix(Vec3(0.0, 0.0, 1e-4)) * exact_rotation(t);
    const Vec3 H = exact_momentum(t) + Vec3(0.0, 1.2, 0.0);
    // T at t = π.
    const double T = 72.0 * (0.75 + 0.25 / 0.75);
    const Errors some = compute_errors(t, turned, H, exact_kinetic_energy(t) - 0.01 * T);
    CHECK(some.orientation == Approx(std::sqrt(2.0) * 1e-4).epsilon(1e-8));
    CHECK(some.momentum == Approx(0.1).epsilon(1e-12));
    CHECK(some.energy == Approx(0.01).epsilon(1e-12));
}

TEST_CASE("the model of the paper's problem is that body under that moment", "[verification]") {
    const Model model = make_model();
    REQUIRE(model.bodies.size() == 1);
    const Mat3 axes = model.bodies[0].attitude.toRotationMatrix();
    CHECK((axes * model.bodies[0].inertia * axes.transpose() - compute_inertia(0.0)).norm() < 1e-15);
    for (const double t : times) {
        CHECK(model.loads[0].moment[2](t) == moment(t).z());
        CHECK(model.loads[0].frame == Frame::spatial);
    }
    CHECK(model.loads[0].moment[0].is_zero());
}

TEST_CASE("one step of the matrix Runge-Kutta scheme errs as the fifth power of its length",
          "[verification]") {
    const auto measure = [](double dt) {
        const double t = 2.0;
        const MatrixMotion motion{exact_rotation(t), exact_angular_velocity(t)};
        const MatrixMotion next = step_matrix_rk4(motion, t, dt);
        CHECK((compute_momentum(next) - exact_momentum(t + dt)).norm() < 50.0 * std::pow(dt, 4));
        return (next.Lambda - exact_rotation(t + dt)).norm();
    };
    CHECK(std::log2(measure(4e-3) / measure(2e-3)) == Approx(5.0).margin(0.1));
}
