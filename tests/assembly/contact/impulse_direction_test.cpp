#include "assembly/contact/impulse_direction.hpp"

#include <algorithm>
#include <cmath>

#include "tools/catch.hpp"
#include "tools/random_values.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

// A place outside a sphere of radius 1 around the origin.
SurfaceTouch touch_sphere(const Vec3& place) {
    const double distance = place.norm();
    const Vec3 n = place / distance;
    return {distance - 1.0, n, (Mat3::Identity() - n * n.transpose()) / distance, Vec3::Zero(), 1.0};
}

Vec3 push(const ImpulseDirection& direction, const SurfaceTouch& touch) {
    PlaceForce force{touch.normal, {}, {}, false};
    direction.add_to(touch, {1.0, 0.0}, force);
    return force.force;
}

}  // namespace

TEST_CASE("impulses: the work is that of the change of the gap, whichever side is reached",
          "[assembly][touch]") {
    RandomValues random(61);
    int passed = 0;
    for (int k = 0; k < 100; ++k) {
        INFO(k);
        const Vec3 before = random.number(1.0, 1.2) * random.direction();
        const Vec3 after = random.number(1.0, 1.2) * random.direction();
        const SurfaceTouch start = touch_sphere(before), end = touch_sphere(after);
        const double cosine = start.normal.dot(end.normal);
        passed += cosine < 0.0 ? 1 : 0;
        const Vec3 along = push({start.normal}, end);
        // By more than a right angle it is a part of it, which falls to nothing straight on the other side.
        const double part = std::min(1.0, 1.0 + cosine);
        CHECK(std::abs(along.dot(after - before) - part * (end.gap - start.gap)) <
              1e-14 * (1.0 + along.norm()));
        const ImpulseDirection on_mesh{
            std::nullopt, ImpulseDirection::Way{start.normal, after - before, end.gap - start.gap, 1e-9}};
        CHECK(std::abs(push(on_mesh, end).dot(after - before) - (end.gap - start.gap)) < 1e-14);
    }
    CHECK(passed > 30);
}

TEST_CASE("impulses: the derivative by the place is that of the force", "[assembly][touch]") {
    RandomValues random(62);
    for (int k = 0; k < 40; ++k) {
        INFO(k);
        const Vec3 before = 1.1 * random.direction(), after = 1.2 * random.direction();
        if (std::abs(before.dot(after)) < 1e-3) continue;
        const Vec3 normal = touch_sphere(before).normal, by = random.vector();
        const double stiffness = 3.0;
        // λ = 1 − D (g − g₀)
        const auto force_at = [&](double h) {
            const SurfaceTouch touch = touch_sphere(after + h * by);
            const NormalForce at{1.0 - stiffness * (touch.gap - (after.norm() - 1.0)), stiffness};
            PlaceForce turned;
            ImpulseDirection{normal}.add_to(touch, at, turned);
            return turned.force;
        };
        PlaceForceDerivative found;
        ImpulseDirection{normal}.add_to(touch_sphere(after), {1.0, stiffness}, found);
        const double h = 1e-5;
        const Vec3 difference = (force_at(h) - force_at(-h)) / (2.0 * h);
        CHECK((found.force_by_position * by - difference).norm() < 1e-8);
    }
}
