#include "contact/place_force.hpp"

#include <cmath>

#include "tools/catch.hpp"
#include "tools/difference.hpp"
#include "tools/random_values.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

// A place at the unit sphere, whose normal turns with it, pressed by a force that falls with the gap.
struct Scene {
    Vec3 position = Vec3(0.7, 0.5, 0.9);
    Vec3 start = Vec3(0.69, 0.52, 0.91);
    Vec3 rotation = Vec3(0.02, -0.03, 0.04);
    double radius = 0.2;
    CoulombFriction friction{0.4, 30.0, Vec3(0.1, -0.2, 0.05)};

    PlaceForce force() const { return compute_place_force(touch(), motion(), normal(), friction); }
    SurfaceTouch touch() const {
        const double d = position.norm();
        const Vec3 n = position / d;
        return {d - 1.0 - radius, n, (Mat3::Identity() - n * n.transpose()) / d, Vec3(0.01, 0.0, 0.02)};
    }
    PlaceMotion motion() const { return {position - start, rotation, radius}; }
    NormalForce normal() const {
        const double gap = touch().gap;
        return {3.0 - 5.0 * gap, 5.0};
    }
};

double tangent_error(const Scene& scene) {
    const PlaceForceDerivative found =
        compute_place_force_derivative(scene.touch(), scene.motion(), scene.normal(), scene.friction);
    PlaceForceDerivative expected;
    const auto column = [&](auto change, auto part) {
        return differentiate(
            [&](double amount) {
                Scene moved = scene;
                change(moved, amount);
                return Vec3(part(moved.force()));
            },
            1e-4);
    };
    const auto force = [](const PlaceForce& all) { return all.force; };
    const auto moment = [](const PlaceForce& all) { return all.moment; };
    for (int i = 0; i < 3; ++i) {
        const auto move = [&](Scene& moved, double amount) { moved.position[i] += amount; };
        const auto turn = [&](Scene& moved, double amount) { moved.rotation[i] += amount; };
        expected.force_by_position.col(i) = column(move, force);
        expected.force_by_rotation.col(i) = column(turn, force);
        expected.moment_by_position.col(i) = column(move, moment);
        expected.moment_by_rotation.col(i) = column(turn, moment);
    }
    return (found.force_by_position - expected.force_by_position).norm() +
           (found.force_by_rotation - expected.force_by_rotation).norm() +
           (found.moment_by_position - expected.moment_by_position).norm() +
           (found.moment_by_rotation - expected.moment_by_rotation).norm();
}

}  // namespace

TEST_CASE("a place that touches: its tangent is the derivative of its force", "[contact]") {
    Scene scene;
    SECTION("without friction") { scene.friction = {}; }
    SECTION("sticking") { CHECK_FALSE(scene.force().slides); }
    SECTION("sliding") {
        scene.friction.stiffness = 200.0;
        CHECK(scene.force().slides);
    }
    SECTION("sliding, by direction and speed") {
        static constexpr FrictionShape shape{0.2, 0.6, 1.0, 0.5, 0.2};
        scene.friction.stiffness = 200.0;
        scene.friction.shape = &shape;
        scene.friction.axes[0] = Vec3(0.6, 0.0, -0.8);
        scene.friction.elapsed = 0.1;
        CHECK(scene.force().slides);
    }
    CHECK(tangent_error(scene) < 1e-7);
}

TEST_CASE("a place that touches: its force by the axis and by the normal force", "[contact]") {
    static constexpr FrictionShape shape{0.2, 0.6, 1.0, 0.5, 0.2};
    Scene scene;
    scene.friction.stiffness = 200.0;
    scene.friction.shape = &shape;
    scene.friction.axes[0] = Vec3(0.6, 0.0, -0.8);
    scene.friction.elapsed = 0.1;
    const PlaceForceDerivative found =
        compute_place_force_derivative(scene.touch(), scene.motion(), scene.normal(), scene.friction);
    for (int k = 0; k < 3; ++k) {
        const auto by_axis = [&](auto part) {
            return differentiate(
                [&](double amount) {
                    Scene turned = scene;
                    turned.friction.axes[0][k] += amount;
                    return Vec3(part(turned.force()));
                },
                1e-4);
        };
        CHECK((found.force_by_axis.col(k) - by_axis([](const PlaceForce& all) { return all.force; })).norm() <
              1e-7);
        CHECK((found.moment_by_axis.col(k) - by_axis([](const PlaceForce& all) {
                   return all.moment;
               })).norm() < 1e-7);
    }
    const Vec3 by_force = differentiate(
        [&](double amount) {
            const NormalForce normal{scene.normal().force + amount, 5.0};
            return compute_place_force(scene.touch(), scene.motion(), normal, scene.friction).traction;
        },
        1e-4);
    CHECK(
        (compute_traction_by_force(scene.touch(), scene.motion(), scene.normal(), scene.friction) - by_force)
            .norm() < 1e-7);
}

TEST_CASE("a place that touches: friction is in the cone, against the slip of the surface", "[contact]") {
    const SurfaceTouch floor{0.01, Vec3::UnitZ()};
    const NormalForce pressed{2.0, 1.0};
    SECTION("sticks by its stiffness") {
        const PlaceForce force =
            compute_place_force(floor, {Vec3(1e-3, 0, 0), Vec3::Zero(), 0.1}, pressed, {0.5, 100.0});
        CHECK(relative_difference(force.traction, Vec3(-0.1, 0, 0)) < 1e-14);
        // About the line, of a force at the bottom.
        CHECK(relative_difference(force.moment, Vec3(0, 0.01, 0)) < 1e-14);
    }
    SECTION("slides with the coefficient times the normal force") {
        const PlaceForce force =
            compute_place_force(floor, {Vec3(3, 4, 0), Vec3::Zero(), 0.1}, pressed, {0.5, 100.0});
        CHECK(force.slides);
        CHECK(relative_difference(force.force, Vec3(-0.6, -0.8, 2.0)) < 1e-14);
    }
    SECTION("does not act on a rod that rolls, nor on one that goes with the surface") {
        // Along y a rod turns about −x.
        const PlaceForce rolling =
            compute_place_force(floor, {Vec3(0, 0.02, 0), Vec3(-0.2, 0, 0), 0.1}, pressed, {0.5, 100.0});
        CHECK(rolling.traction.norm() < 1e-14);
        SurfaceTouch belt = floor;
        belt.drift = Vec3(0.3, 0, 0);
        CHECK(compute_place_force(belt, {Vec3(0.3, 0, 0)}, pressed, {0.5, 100.0}).traction.norm() < 1e-14);
    }
    SECTION("does not pull from where nothing presses") {
        CHECK(compute_place_force(floor, {Vec3(1, 0, 0)}, {-1.0, 1.0}, {0.5, 100.0}).traction.norm() == 0.0);
    }
}
