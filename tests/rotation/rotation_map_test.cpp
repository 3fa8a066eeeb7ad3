#include "rotation/rotation_map.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "rotation/samples.hpp"
#include "tools/catch.hpp"

using namespace gxrod;

namespace {

using std::numbers::pi;
constexpr double turn = 2.0 * pi;

// (3.2) as the paper writes it.
Mat3 rotate_about(const Vec3& axis, double angle) {
    const Mat3 along = axis * axis.transpose();
    return along + std::cos(angle) * (Mat3::Identity() - along) + std::sin(angle) * spin(axis);
}

// Distance of two rotation vectors, ±φ being one rotation where |φ| = π.
double distance(const Vec3& result, const Vec3& expected) {
    const double plain = (result - expected).norm();
    return expected.norm() < pi - 1e-15 ? plain : std::min(plain, (result + expected).norm());
}

}  // namespace

TEST_CASE("spin and axial are inverse to each other", "[rotation][rotation_map]") {
    samples::Random random(11);
    for (int i = 0; i < 100; ++i) {
        const Vec3 u = random.vector();
        const Vec3 v = random.vector();
        CHECK(axial(spin(u)) == u);
        CHECK((spin(u) * v - u.cross(v)).norm() <= 1e-15 * u.norm() * v.norm());
        CHECK((axial(spin(u) + v * v.transpose()) - u).norm() <= 1e-14);
    }
}

TEST_CASE("exp turns counter-clockwise about its vector", "[rotation][rotation_map]") {
    const Mat3 quarter = exp_matrix(Vec3(0.0, 0.0, 0.5 * pi));
    CHECK((quarter * Vec3::UnitX() - Vec3::UnitY()).norm() <= 1e-15);
    CHECK((quarter * Vec3::UnitY() + Vec3::UnitX()).norm() <= 1e-15);
    CHECK(exp_matrix(Vec3::Zero()) == Mat3::Identity());
}

TEST_CASE("exp is (3.2), orthogonal and proper", "[rotation][rotation_map]") {
    samples::Random random(12);
    for (const double angle : samples::angles_past_pi()) {
        for (int i = 0; i < 20; ++i) {
            const Vec3 axis = random.direction();
            const Mat3 Lambda = exp_matrix(angle * axis);
            INFO("angle " << angle);
            CHECK((Lambda - rotate_about(axis, angle)).norm() <= 1e-14);
            CHECK((Lambda * Lambda.transpose() - Mat3::Identity()).norm() <= 1e-14);
            CHECK(std::abs(Lambda.determinant() - 1.0) <= 1e-14);
            CHECK((exp_matrix(-angle * axis) - Lambda.transpose()).norm() == 0.0);
            CHECK(std::abs(exp_quaternion(angle * axis).norm() - 1.0) <= 1e-15);
        }
    }
}

TEST_CASE("log undoes exp to 1e-14, through quaternion and matrix", "[rotation][rotation_map]") {
    samples::Random random(13);
    for (const double angle : samples::angles_to_pi()) {
        for (int i = 0; i < 500; ++i) {
            const Vec3 phi = angle * random.direction();
            const Quat q = exp_quaternion(phi);
            const Quat opposite(-q.coeffs());
            INFO("angle " << angle << ", phi " << phi.transpose());
            CHECK(distance(log(q), phi) <= 1e-14);
            CHECK(distance(log(opposite), phi) <= 1e-14);
            CHECK(distance(log(exp_matrix(phi)), phi) <= 1e-14);
        }
    }
    for (int i = 0; i < 20000; ++i) {
        const Vec3 phi = random.between(0.0, pi) * random.direction();
        CHECK((log(exp_quaternion(phi)) - phi).norm() <= 1e-14);
        CHECK((log(exp_matrix(phi)) - phi).norm() <= 1e-14);
    }
}

TEST_CASE("log keeps the relative accuracy of small rotations", "[rotation][rotation_map]") {
    samples::Random random(14);
    for (const double angle : {1e-300, 1e-200, 1e-160, 1e-154, 1e-100, 1e-12, 1e-9, 2e-9, 1e-8, 1e-4}) {
        for (int i = 0; i < 100; ++i) {
            const Vec3 phi = angle * random.direction();
            INFO("angle " << angle);
            CHECK((log(exp_quaternion(phi)) - phi).cwiseAbs().maxCoeff() <= 1e-15 * angle);
            CHECK((log(exp_matrix(phi)) - phi).cwiseAbs().maxCoeff() <= 1e-15 * angle);
        }
    }
    CHECK(log(Quat::Identity()) == Vec3::Zero());
    CHECK(log(Quat(-1.0, 0.0, 0.0, 0.0)) == Vec3::Zero());
    CHECK(log(Mat3(Mat3::Identity())) == Vec3::Zero());
}

TEST_CASE("exp and log keep their digits where series end", "[rotation][rotation_map]") {
    constexpr double rounding = 4.0 * std::numeric_limits<double>::epsilon();
    const auto check = [&](double angle) {
        INFO("angle " << angle);
        const Quat q = exp_quaternion(Vec3(0.0, angle, 0.0));
        const long double half = 0.5L * static_cast<long double>(angle);
        CHECK(std::abs(static_cast<double>(q.w() - std::cos(half))) <= rounding);
        CHECK(std::abs(static_cast<double>(q.y() - std::sin(half))) <= rounding * angle);
        const Vec3 phi = log(q);
        const double exact = static_cast<double>(
            2.0L * std::atan2(static_cast<long double>(q.y()), static_cast<long double>(q.w())));
        CHECK(std::abs(phi.y() - exact) <= rounding * angle);
    };
    for (double angle = 1e-6; angle < pi; angle *= 1.01) check(angle);
    // exp changes at 1, log at 2 asin 1/4.
    for (const double change : {1.0, 2.0 * std::asin(0.25)})
        for (int i = -20; i <= 20; ++i) check(change * (1.0 + 1e-3 * i));
}

TEST_CASE("log of half turns about the axes and their diagonals", "[rotation][rotation_map]") {
    for (const Vec3& direction : {Vec3(1, 0, 0),
                                  Vec3(0, 1, 0),
                                  Vec3(0, 0, 1),
                                  Vec3(1, 1, 0),
                                  Vec3(0, -1, 1),
                                  Vec3(1, 0, -1),
                                  Vec3(1, 1, 1),
                                  Vec3(-1, 1, -1)}) {
        const Vec3 axis = direction.normalized();
        const Mat3 half_turn = 2.0 * axis * axis.transpose() - Mat3::Identity();
        CHECK(distance(log(half_turn), pi * axis) <= 1e-14);
        CHECK(distance(log(Quat(0.0, axis.x(), axis.y(), axis.z())), pi * axis) <= 1e-14);
    }
}

TEST_CASE("log never exceeds half a turn", "[rotation][rotation_map]") {
    samples::Random random(15);
    for (int i = 0; i < 2000; ++i) {
        const Vec3 phi = random.between(0.0, 8.0 * pi) * random.direction();
        const Vec3 principal = log(exp_quaternion(phi));
        CHECK(principal.norm() <= pi * (1.0 + 1e-15));
        CHECK((exp_matrix(principal) - exp_matrix(phi)).norm() <= 2e-14);
    }
}

TEST_CASE("log_nearest finds the turn of its guess", "[rotation][rotation_map]") {
    samples::Random random(16);
    for (const double angle : {1e-8, 1e-4, 0.3, 2.0, 3.0, pi - 1e-9, pi}) {
        for (int turns = -4; turns <= 4; ++turns) {
            for (int i = 0; i < 20; ++i) {
                const Vec3 axis = random.direction();
                const Vec3 expected = (angle + turns * turn) * axis;
                // Less than half a turn off along the axis; off it, by as much as one likes.
                const Vec3 across = axis.cross(random.vector());
                const Vec3 guess = expected + random.between(-3.1, 3.1) * axis + 5.0 * across;
                const Quat q = exp_quaternion(angle * axis);
                INFO("angle " << angle << ", turns " << turns);
                CHECK((log_nearest(q, guess) - expected).norm() <= 1e-14 * (1.0 + std::abs(turns)));
            }
        }
    }
}

TEST_CASE("log_nearest gives the closest of all vectors of a rotation", "[rotation][rotation_map]") {
    samples::Random random(17);
    for (int i = 0; i < 2000; ++i) {
        const Quat q = exp_quaternion(random.between(0.1, 3.1) * random.direction());
        const Vec3 guess = 6.0 * random.vector();
        const Vec3 nearest = log_nearest(q, guess);
        const Vec3 axis = log(q).normalized();
        CHECK((exp_matrix(nearest) - q.toRotationMatrix()).norm() <= 2e-14);
        for (int turns = -6; turns <= 6; ++turns) {
            const Vec3 other = log(q) + turns * turn * axis;
            CHECK((nearest - guess).norm() <= (other - guess).norm() + 1e-13);
        }
    }
}

TEST_CASE("log_nearest takes the axis of its guess where the rotation has none", "[rotation][rotation_map]") {
    samples::Random random(18);
    for (int turns = 1; turns <= 4; ++turns) {
        for (int i = 0; i < 20; ++i) {
            const Vec3 axis = random.direction();
            const Vec3 whole_turns = turns * turn * axis;
            const Vec3 guess = whole_turns + random.between(-3.1, 3.1) * axis;
            const Vec3 noise = 3e-16 * random.direction();
            const Quat blurred = exp_quaternion(noise);
            CHECK((log_nearest(Quat::Identity(), guess) - whole_turns).norm() <= 1e-14 * turns);
            CHECK((log_nearest(Quat(-1.0, 0.0, 0.0, 0.0), guess) - whole_turns).norm() <= 1e-14 * turns);
            CHECK((log_nearest(blurred, guess) - whole_turns).norm() <= 1e-14 * turns);
        }
    }
    CHECK(log_nearest(Quat::Identity(), Vec3::Zero()) == Vec3::Zero());
    CHECK(log_nearest(Quat::Identity(), Vec3(0.0, 3.0, 0.0)) == Vec3::Zero());
    const Vec3 tiny(1e-300, -2e-300, 3e-300);
    CHECK(log_nearest(exp_quaternion(tiny), Vec3::Zero()) == tiny);
}

TEST_CASE("compose multiplies rotations, the second from the left", "[rotation][rotation_map]") {
    samples::Random random(19);
    for (int i = 0; i < 2000; ++i) {
        const Vec3 first = random.between(0.0, pi) * random.direction();
        const Vec3 second = random.between(0.0, pi) * random.direction();
        const Vec3 both = compose(second, first);
        CHECK((exp_matrix(both) - exp_matrix(second) * exp_matrix(first)).norm() <= 1e-14);
        CHECK(both.norm() <= pi * (1.0 + 1e-15));
        CHECK((compose(-first, first)).norm() <= 1e-15);
    }
    const Vec3 small(1e-12, -2e-12, 5e-13);
    CHECK((compose(small, small) - 2.0 * small).norm() <= 1e-15 * small.norm());
}
