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

// Outside a capsule of radius 1 from the origin along x.
SurfaceTouch touch_capsule(const Vec3& place) {
    const Vec3 closest(std::max(place.x(), 0.0), 0, 0);
    SurfaceTouch touch = touch_sphere(place - closest);
    if (place.x() > 0.0) touch.curvature.row(0).setZero(), touch.curvature.col(0).setZero();
    return touch;
}

// As from `before` to `after` past an obstacle at rest.
ImpulseDirection limited(const SurfaceTouch& start,
                         const SurfaceTouch& end,
                         const Vec3& move,
                         double below = 0.0) {
    return {start.normal, ImpulseDirection::Way{start.normal, move, end.gap - start.gap - below, 1e-9}};
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

TEST_CASE("impulses: what slides over the edge of an end does no more work than the change of the gap",
          "[assembly][touch]") {
    RandomValues random(63);
    int gained = 0;
    for (int k = 0; k < 200; ++k) {
        INFO(k);
        const Vec3 before = Vec3(random.number(0.0, 1.0), 0, 0) + 1.1 * random.direction();
        const Vec3 after = Vec3(random.number(-1.0, 0.0), 0, 0) + 1.1 * random.direction();
        const SurfaceTouch start = touch_capsule(before), end = touch_capsule(after);
        const Vec3 move = after - before;
        if (start.gap < 0.0 || end.gap < 0.0) continue;
        const double change = end.gap - start.gap, work = push({start.normal}, end).dot(move);
        const double less = push(limited(start, end, move), end).dot(move);
        // By nine tenths of the force at most.
        CHECK(less <= std::max(change, work - 0.9 * move.norm()) + 1e-12);
        CHECK(less <= work + 1e-12);
        if (work <= change) CHECK(less == Approx(work).margin(1e-12));
        gained += work > change + 0.01 ? 1 : 0;
    }
    CHECK(gained > 20);
}

TEST_CASE("impulses: limited ones have their derivative", "[assembly][touch]") {
    RandomValues random(64);
    int lessened = 0, capped = 0;
    for (int k = 0; k < 300; ++k) {
        INFO(k);
        const Vec3 before = Vec3(random.number(0.2, 1.0), 0, 0) + 1.1 * random.direction();
        const Vec3 after = Vec3(random.number(-1.0, 1.0), 0, 0) + 1.2 * random.direction();
        const SurfaceTouch start = touch_capsule(before), end = touch_capsule(after);
        const Vec3 by = random.vector();
        const double stiffness = 3.0, h = 1e-5, below = k % 4 == 0 ? 3.0 : 0.0;
        const auto force_at = [&](double step) {
            const Vec3 place = after + step * by;
            const SurfaceTouch touch = touch_capsule(place);
            PlaceForce turned;
            limited(start, touch, place - before, below)
                .add_to(touch, {1.0 - stiffness * (touch.gap - end.gap), stiffness}, turned);
            return turned.force;
        };
        // Away from where it begins and ends to be limited, and from the edge.
        const Vec3 move = after - before;
        const double excess =
            (push({start.normal}, end).dot(move) - (end.gap - start.gap - below)) / move.norm();
        if (std::abs(excess) < 1e-3 || std::abs(excess - 0.9) < 1e-3 || std::abs(after.x()) < 1e-3 ||
            std::abs(start.normal.dot(end.normal)) < 1e-3)
            continue;
        PlaceForceDerivative found;
        limited(start, end, move, below).add_to(end, {1.0, stiffness}, found);
        const Vec3 difference = (force_at(h) - force_at(-h)) / (2.0 * h);
        CHECK((found.force_by_position * by - difference).norm() < 1e-7);
        lessened += excess > 0.0 && excess < 0.9 ? 1 : 0;
        capped += excess > 0.9 ? 1 : 0;
    }
    INFO(lessened << " " << capped);
    CHECK(lessened > 20);
    CHECK(capped > 3);
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
