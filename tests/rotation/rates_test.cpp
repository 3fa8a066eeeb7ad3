#include "rotation/rates.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "rotation/rotation_map.hpp"
#include "rotation/samples.hpp"
#include "tools/catch.hpp"

using namespace gxrod;

namespace {

using std::numbers::pi;
constexpr double step = 0.004;

// A smooth motion of a rotation vector, φ(t) = φ0 + φ̇0 t + ½ φ̈0 t², and what it makes of its body.
struct Path {
    Vec3 phi;
    Vec3 phi_dot;
    Vec3 phi_ddot;

    Vec3 phi_at(double t) const { return phi + t * phi_dot + 0.5 * t * t * phi_ddot; }
    Vec3 phi_dot_at(double t) const { return phi_dot + t * phi_ddot; }
    Mat3 Lambda_at(double t) const { return exp_matrix(phi_at(t)); }
    Vec3 omega_at(double t) const { return angular_velocity(phi_at(t), phi_dot_at(t)); }
    Vec3 omega_dot_at(double t) const { return angular_acceleration(phi_at(t), phi_dot_at(t), phi_ddot); }
};

// Calls check(path) for paths that start at every special angle and at random angles.
template <typename Check>
void for_random_paths(unsigned seed, Check check) {
    samples::Random random(seed);
    const auto call = [&](double angle) {
        const Vec3 phi = angle * random.direction();
        const Vec3 phi_dot = random.vector();
        const Vec3 phi_ddot = random.vector();
        INFO("angle " << angle << ", phi " << phi.transpose());
        check(Path{phi, phi_dot, phi_ddot});
    };
    for (const double angle : samples::angles_past_pi())
        for (int i = 0; i < 10; ++i) call(angle);
    for (int i = 0; i < 300; ++i) call(random.between(0.0, 5.0));
}

// φ̈ by (3.7b) as the paper splits it, into angle and axis; needs 0 < Φ < 2π, and accuracy fades as Φ → 0.
Vec3 split_second_rate(const Vec3& phi, const Vec3& omega, const Vec3& omega_dot) {
    const double angle = phi.norm();
    const Vec3 f = phi / angle;
    const double k = 0.5 / std::tan(0.5 * angle);
    const Vec3 across = omega - f.dot(omega) * f;
    const double angle_rate = f.dot(omega);
    const double angle_second = f.dot(omega_dot) + k * across.squaredNorm();
    const double k_rate = -0.25 * angle_rate / std::pow(std::sin(0.5 * angle), 2);
    const Vec3 f_rate = k * across - 0.5 * f.cross(omega);
    const Vec3 across_rate = omega_dot - (f_rate.dot(omega) + f.dot(omega_dot)) * f - f.dot(omega) * f_rate;
    const Vec3 f_second =
        k_rate * across + k * across_rate - 0.5 * f_rate.cross(omega) - 0.5 * f.cross(omega_dot);
    return angle_second * f + 2.0 * angle_rate * f_rate + angle * f_second;
}

}  // namespace

TEST_CASE("(3.6a): the angular velocity is the axial vector of the rate of exp", "[rotation][rates]") {
    for_random_paths(31, [](const Path& path) {
        const Mat3 rate = samples::central_difference([&](double t) { return path.Lambda_at(t); }, step);
        const Mat3 spin_of_exp = rate * path.Lambda_at(0.0).transpose();
        CHECK((spin_of_exp - spin(path.omega_at(0.0))).norm() <= 1e-10);
    });
}

TEST_CASE("(3.6b): the angular acceleration is the rate of (3.6a)", "[rotation][rates]") {
    for_random_paths(32, [](const Path& path) {
        const Vec3 rate = samples::central_difference([&](double t) { return path.omega_at(t); }, step);
        CHECK((path.omega_dot_at(0.0) - rate).norm() <= 1e-10);
    });
}

TEST_CASE("(3.7a,b) undo (3.6a,b)", "[rotation][rates]") {
    for_random_paths(33, [](const Path& path) {
        const RotationVectorMotion motion =
            rotation_vector_motion(path.phi, path.omega_at(0.0), path.omega_dot_at(0.0));
        CHECK(motion.phi == path.phi);
        CHECK((motion.phi_dot - path.phi_dot).norm() <= 1e-14 * (1.0 + path.phi_dot.norm()));
        const double size = 1.0 + path.phi_dot.squaredNorm() + path.phi_ddot.norm();
        CHECK((motion.phi_ddot - path.phi_ddot).norm() <= 1e-14 * size);
    });
}

TEST_CASE("(3.7b) equals its split into angle and axis", "[rotation][rates]") {
    for_random_paths(34, [](const Path& path) {
        if (path.phi.norm() < 0.1) return;
        const Vec3 omega = path.omega_at(0.0);
        const Vec3 omega_dot = path.omega_dot_at(0.0);
        const Vec3 phi_ddot = rotation_vector_motion(path.phi, omega, omega_dot).phi_ddot;
        const double size = 1.0 + omega.squaredNorm() + omega_dot.norm();
        CHECK((phi_ddot - split_second_rate(path.phi, omega, omega_dot)).norm() <= 1e-12 * size);
    });
}

TEST_CASE("(3.8): rates of the angle", "[rotation][rates]") {
    using Scalar = Eigen::Matrix<double, 1, 1>;
    for_random_paths(35, [](const Path& path) {
        const double angle = path.phi.norm();
        if (angle == 0.0) return;
        const AngleRates rates = angle_rates(path.phi, path.omega_at(0.0), path.omega_dot_at(0.0));
        const Vec3 axis = path.phi.stableNormalized();
        CHECK(rates.first == Approx(axis.dot(path.phi_dot)).margin(1e-13));
        if (angle < 0.1) return;
        const double across = axis.cross(path.phi_dot).squaredNorm();
        CHECK(rates.second == Approx(axis.dot(path.phi_ddot) + across / angle).epsilon(1e-12).margin(1e-12));
        if (angle < 0.4) return;
        const auto first_at = [&](double t) {
            return Scalar(angle_rates(path.phi_at(t), path.omega_at(t), path.omega_dot_at(t)).first);
        };
        const double scale = 1.0 + std::abs(rates.second);
        const double difference = samples::central_difference(first_at, 1e-3)(0);
        CHECK(std::abs(rates.second - difference) <= 1e-9 * scale);
    });
}

TEST_CASE("(3.11): the limits at the identity", "[rotation][rates]") {
    samples::Random random(36);
    for (int i = 0; i < 50; ++i) {
        const Path path{Vec3::Zero(), random.vector(), random.vector()};
        const Vec3 omega = path.omega_at(0.0);
        const Vec3 omega_dot = path.omega_dot_at(0.0);
        const Vec3 direction = omega.normalized();
        const Vec3 blur = 4e-16 * random.direction();
        for (const Vec3& phi : {Vec3(0.0, 0.0, 0.0), blur}) {
            const Mat3 Lambda = exp_matrix(phi);
            const RotationVectorMotion motion = rotation_vector_motion(Lambda, omega, omega_dot);
            CHECK(motion.phi.norm() <= 1e-15);
            CHECK((motion.phi_dot - omega).norm() <= 1e-14);
            CHECK((motion.phi_ddot - omega_dot).norm() <= 1e-14);
            CHECK((rotation_axis(Lambda, omega, omega_dot) - direction).norm() <= 1e-15);
        }
        // Just before and after, the regular formulas have come as near to the limits as the path has.
        for (const double t : {-1e-6, 1e-6}) {
            const Mat3 Lambda = path.Lambda_at(t);
            const RotationVectorMotion near =
                rotation_vector_motion(Lambda, path.omega_at(t), path.omega_dot_at(t));
            CHECK((near.phi_dot - omega).norm() <= 2e-6 * omega_dot.norm());
            CHECK((near.phi_ddot - omega_dot).norm() <= 1e-13);
            const Vec3 axis = rotation_axis(Lambda, path.omega_at(t), path.omega_dot_at(t));
            CHECK((axis - (t < 0.0 ? -1.0 : 1.0) * direction).norm() <=
                  2e-6 * omega_dot.norm() / omega.norm());
        }
    }
}

TEST_CASE("(3.11): the axis at the identity of a body that only starts to move", "[rotation][rates]") {
    samples::Random random(37);
    for (int i = 0; i < 50; ++i) {
        const Path path{Vec3::Zero(), Vec3::Zero(), random.vector()};
        const Vec3 direction = path.phi_ddot.normalized();
        for (const double t : {-1e-4, 0.0, 1e-4}) {
            const Vec3 axis = rotation_axis(path.Lambda_at(t), path.omega_at(t), path.omega_dot_at(t));
            CHECK((axis - direction).norm() <= 1e-14);
        }
    }
    CHECK(rotation_axis(Mat3::Identity(), Vec3::Zero(), Vec3::Zero()) == Vec3::Zero());
    CHECK(rotation_axis(Mat3::Identity(), Vec3(0.0, 1e-300, 0.0), Vec3::UnitX()) == Vec3::UnitY());
}

namespace {

// What the path becomes where its angle has passed π: the same rotations by the vector φ − 2π f, which |φ| ≤
// π asks.
Vec3 complement_at(const Path& path, double t) {
    const Vec3 phi = path.phi_at(t);
    return (1.0 - 2.0 * pi / phi.norm()) * phi;
}

Vec3 complement_rate_at(const Path& path, double t) {
    const Vec3 phi = path.phi_at(t);
    const Vec3 phi_dot = path.phi_dot_at(t);
    const double angle = phi.norm();
    return (1.0 - 2.0 * pi / angle) * phi_dot + (2.0 * pi * phi.dot(phi_dot) / std::pow(angle, 3)) * phi;
}

// A path through |φ| = π at t = 0 where the angle has the given rates.
Path make_path_through_half_turn(samples::Random& random, double angle_rate, double angle_second) {
    const Vec3 axis = random.direction();
    const Vec3 across = axis.cross(random.vector());
    const Vec3 acceleration_across = axis.cross(random.vector());
    const double along = angle_second - across.squaredNorm() / pi;
    return {pi * axis, angle_rate * axis + across, along * axis + acceleration_across};
}

void check_limits_at_half_turn(const Path& path, bool rises) {
    const Vec3 omega = path.omega_at(0.0);
    const Vec3 omega_dot = path.omega_dot_at(0.0);
    const Mat3 Lambda = path.Lambda_at(0.0);
    const RotationVectorMotion motion = rotation_vector_motion(Lambda, omega, omega_dot);
    const Vec3 f = rotation_axis(Lambda, omega, omega_dot);

    // The branch whose angle falls, with its rates.
    const Vec3 phi_dot = rises ? complement_rate_at(path, 0.0) : path.phi_dot;
    const Vec3 phi_ddot =
        rises ? samples::central_difference([&](double t) { return complement_rate_at(path, t); }, step)
              : path.phi_ddot;
    CHECK((motion.phi - (rises ? -1.0 : 1.0) * path.phi).norm() <= 1e-14);
    CHECK((motion.phi_dot - phi_dot).norm() <= 1e-13);
    CHECK((motion.phi_ddot - phi_ddot).norm() <= 1e-11);

    // (3.12) and (3.13) as the paper writes them.
    CHECK((f - motion.phi / pi).norm() <= 1e-14);
    const Vec3 f_cross_omega = f.cross(omega);
    const double spin_along = f.dot(omega);
    const Vec3 limit_first = spin_along * f - 0.5 * pi * f_cross_omega;
    const Vec3 limit_second = f.dot(omega_dot) * f - 0.25 * pi * f_cross_omega.squaredNorm() * f -
                              spin_along * f_cross_omega - 0.5 * pi * f.cross(omega_dot);
    CHECK((motion.phi_dot - limit_first).norm() <= 1e-13);
    CHECK((motion.phi_ddot - limit_second).norm() <= 1e-12);

    // Just after, the regular formulas are on the same branch.
    const double soon = 1e-5;
    const RotationVectorMotion after =
        rotation_vector_motion(path.Lambda_at(soon), path.omega_at(soon), path.omega_dot_at(soon));
    const Vec3 phi_after = rises ? complement_at(path, soon) : path.phi_at(soon);
    CHECK(after.phi.norm() < pi);
    CHECK((after.phi - phi_after).norm() <= 1e-14);
    CHECK((after.phi - motion.phi).norm() <= 2.0 * soon * phi_dot.norm());
    CHECK((after.phi_dot - motion.phi_dot).norm() <= 2.0 * soon * (1.0 + phi_ddot.norm()));
}

}  // namespace

TEST_CASE("(3.12-3.13): the limits at half a turn", "[rotation][rates]") {
    samples::Random random(38);
    for (int i = 0; i < 50; ++i) {
        const double rate = std::pow(10.0, random.between(-3.0, 0.3));
        const double second = random.between(-2.0, 2.0);
        check_limits_at_half_turn(make_path_through_half_turn(random, rate, second), true);
        check_limits_at_half_turn(make_path_through_half_turn(random, -rate, second), false);
    }
}

TEST_CASE("(3.12-3.13): the acceleration decides where the angle is at rest at half a turn",
          "[rotation][rates]") {
    samples::Random random(39);
    for (int i = 0; i < 50; ++i) {
        const double second = random.between(0.5, 2.0);
        check_limits_at_half_turn(make_path_through_half_turn(random, 0.0, second), true);
        check_limits_at_half_turn(make_path_through_half_turn(random, 0.0, -second), false);
    }
}

TEST_CASE("the axis of a body at rest is that of its rotation", "[rotation][rates]") {
    samples::Random random(40);
    for (const double angle : samples::angles_to_pi()) {
        if (angle < 1e-13) continue;
        const Vec3 f = random.direction();
        const Vec3 axis = rotation_axis(exp_matrix(angle * f), Vec3::Zero(), Vec3::Zero());
        INFO("angle " << angle);
        CHECK(std::min((axis - f).norm(), angle < pi ? 2.0 : (axis + f).norm()) <= 1e-14);
    }
}

TEST_CASE("(3.14-3.15): steady spin over several turns", "[rotation][rates]") {
    const double spin_rate = 1.3;
    const Vec3 omega = spin_rate * Vec3::UnitZ();
    const int steps_per_half_turn = 50;
    const int half_turns = 9;
    double previous_angle = 0.0;
    Vec3 previous_phi = Vec3::Zero();
    for (int i = 0; i <= half_turns * steps_per_half_turn; ++i) {
        const double turned = pi * i / steps_per_half_turn;
        const int completed = i / steps_per_half_turn;
        const bool at_half_turn = i % steps_per_half_turn == 0 && completed % 2 == 1;
        // From an odd multiple of π to the next even one the angle falls, about −e3.
        const bool falls = completed % 2 == 1;
        const double wave = falls ? pi * (completed + 1) - turned : turned - pi * completed;
        const Vec3 axis = falls ? Vec3(-Vec3::UnitZ()) : Vec3(Vec3::UnitZ());
        INFO("turned by " << turned);

        const Mat3 Lambda = exp_matrix(turned * Vec3::UnitZ());
        const RotationVectorMotion motion = rotation_vector_motion(Lambda, omega, Vec3::Zero());
        const double angle = motion.phi.norm();
        CHECK((motion.phi - wave * axis).norm() <= 1e-14);
        CHECK((rotation_axis(Lambda, omega, Vec3::Zero()) - axis).norm() <= 1e-14);
        CHECK((motion.phi_dot - omega).norm() <= 1e-14);
        CHECK(motion.phi_ddot.norm() <= 1e-14);
        if (angle > 1e-12) {
            const AngleRates rates = angle_rates(motion.phi, omega, Vec3::Zero());
            CHECK(rates.first == Approx(falls ? -spin_rate : spin_rate).epsilon(1e-14));
            CHECK(std::abs(rates.second) <= 1e-14);
        }
        if (i > 0) {
            const double advance = pi / steps_per_half_turn;
            CHECK(std::abs(angle - previous_angle) <= advance + 1e-13);
            CHECK(std::abs(angle * angle - previous_angle * previous_angle) <= 2.0 * pi * advance);
            const double jump = (motion.phi - previous_phi).norm();
            CHECK(jump == Approx(at_half_turn ? 2.0 * pi - advance : advance).epsilon(1e-12));
        }
        previous_angle = angle;
        previous_phi = motion.phi;
    }
}
