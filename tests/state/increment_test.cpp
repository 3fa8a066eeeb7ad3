#include "state/increment.hpp"

#include <numbers>

#include "rotation/tangent_map.hpp"
#include "tools/catch.hpp"
#include "tools/difference.hpp"
#include "tools/random_values.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

NodeMotion make_previous(RandomValues& random) {
    NodeMotion previous;
    previous.r = random.vector();
    previous.Lambda = random.rotation();
    return previous;
}

double distance(const Quat& a, const Quat& b) { return a.angularDistance(b); }

}  // namespace

TEST_CASE("a placed node is where it was put", "[state]") {
    RandomValues random(51);
    const NodeMotion previous = make_previous(random);
    const Vec3 r = random.vector();
    const Vec3 theta = random.vector(2.0);
    NodeMotion trial;
    trial.omega = random.vector();
    const Vec3 omega = trial.omega;
    place(previous, r, theta, trial);
    CHECK(trial.r == r);
    CHECK(trial.theta == theta);
    CHECK(trial.omega == omega);
    CHECK(distance(trial.Lambda, exp_quaternion(theta) * previous.Lambda) < 1e-15);
    CHECK(trial.Lambda.norm() == Approx(1.0).epsilon(1e-15));
}

TEST_CASE("a spin turns a node in space and its rotation vector follows", "[state]") {
    RandomValues random(52);
    for (int i = 0; i < 20; ++i) {
        const NodeMotion previous = make_previous(random);
        NodeMotion trial;
        place(previous, random.vector(), random.vector(1.5), trial);
        const NodeMotion before = trial;
        const Vec3 delta_r = random.vector();
        const Vec3 delta_phi = random.vector(0.3);
        apply_spin(previous, delta_r, delta_phi, trial);
        CHECK((trial.r - before.r - delta_r).norm() < 1e-15);
        CHECK(distance(trial.Lambda, exp_quaternion(delta_phi) * before.Lambda) < 1e-15);
        CHECK(distance(trial.Lambda, exp_quaternion(trial.theta) * previous.Lambda) < 1e-15);
    }
}

TEST_CASE("a small spin moves the rotation vector by T(θ)⁻¹ δφ", "[state]") {
    RandomValues random(53);
    for (int i = 0; i < 20; ++i) {
        const NodeMotion previous = make_previous(random);
        NodeMotion trial;
        place(previous, random.vector(), random.number(0.0, 3.0) * random.direction(), trial);
        Mat3 expected;
        for (int k = 0; k < 3; ++k) {
            expected.col(k) = differentiate([&](double amount) {
                NodeMotion moved = trial;
                apply_spin(previous, Vec3::Zero(), amount * Vec3::Unit(k), moved);
                return moved.theta;
            });
        }
        CHECK(relative_difference(tangent_map_inverse(trial.theta), expected) < 1e-9);
    }
}

TEST_CASE("a rotation vector goes past half a turn without a jump", "[state]") {
    // A predictor can pass π; Newton's increments then start from there.
    const NodeMotion previous = [] {
        RandomValues random(54);
        return make_previous(random);
    }();
    NodeMotion trial;
    const Vec3 axis = Vec3(1.0, 2.0, -2.0) / 3.0;
    place(previous, Vec3::Zero(), 3.0 * axis, trial);
    apply_spin(previous, Vec3::Zero(), 0.5 * axis, trial);
    CHECK((trial.theta - 3.5 * axis).norm() < 1e-14);
    apply_spin(previous, Vec3::Zero(), -0.7 * axis, trial);
    CHECK((trial.theta - 2.8 * axis).norm() < 1e-14);
    // Right at half a turn the vector keeps its side.
    place(previous, Vec3::Zero(), (std::numbers::pi - 1e-3) * axis, trial);
    apply_spin(previous, Vec3::Zero(), 2e-3 * axis, trial);
    CHECK((trial.theta - (std::numbers::pi + 1e-3) * axis).norm() < 1e-14);
}

TEST_CASE("whole turns are counted by their spins, whatever round-off says of their axis", "[state]") {
    RandomValues random(55);
    for (const double turns : {1.0, 2.0, 3.0}) {
        const NodeMotion previous = make_previous(random);
        const Vec3 axis = random.direction();
        NodeMotion trial;
        place(previous, Vec3::Zero(), Vec3::Zero(), trial);
        apply_spin(previous, Vec3::Zero(), (2.0 * std::numbers::pi * turns + 1e-3) * axis, trial);
        apply_spin(previous, Vec3::Zero(), -1e-3 * axis, trial);
        for (int i = 0; i < 10; ++i) apply_spin(previous, Vec3::Zero(), random.vector(1e-13), trial);
        CHECK((trial.theta - 2.0 * std::numbers::pi * turns * axis).norm() < 1e-11);
        CHECK(distance(trial.Lambda, previous.Lambda) < 1e-11);
        // Away from there θ is that of Λ again, to the last digit.
        apply_spin(previous, Vec3::Zero(), random.vector(0.03), trial);
        apply_spin(previous, Vec3::Zero(), 2.0 * axis, trial);
        CHECK(distance(trial.Lambda, exp_quaternion(trial.theta) * previous.Lambda) < 1e-14);
        CHECK(trial.theta.norm() == Approx(2.0 * std::numbers::pi * turns + 2.0).margin(0.1));
    }
}
