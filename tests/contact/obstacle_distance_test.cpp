#include "contact/obstacle_distance.hpp"

#include <cmath>
#include <utility>

#include "rotation/rotation_map.hpp"
#include "tools/catch.hpp"
#include "tools/difference.hpp"
#include "tools/random_values.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

Obstacle make(ObstacleShape shape) { return {.name = "", .shape = std::move(shape)}; }

const PlaneShape a_plane{Vec3(0.3, -0.2, 0.5), Vec3(0.2, -0.3, 1.0).normalized()};

// Three quarters of a circle of radius 2 about z.
Obstacle a_ring(double radius, bool is_hollow) {
    TubeShape ring{{radius, is_hollow}, {}, {}};
    constexpr int pieces = 100;
    for (int i = 0; i <= pieces; ++i) {
        const double angle = 1.5 * M_PI * i / pieces;
        ring.line.emplace_back(2.0 * std::cos(angle), 2.0 * std::sin(angle), 0.0);
        ring.tangents.emplace_back(-std::sin(angle), std::cos(angle), 0.0);
    }
    return make(ring);
}

std::vector<Obstacle> all_obstacles() {
    const Vec3 centre(0.1, 0.2, 0.3), from(-1.0, 0.2, 0.0), to(1.0, 0.5, 0.3);
    return {make(a_plane),
            make(SphereShape{{0.4, false}, centre}),
            make(SphereShape{{3.0, true}, centre}),
            make(CylinderShape{{0.3, false}, from, to}),
            make(CylinderShape{{3.0, true}, from, to}),
            a_ring(0.3, false),
            a_ring(3.0, true)};
}

}  // namespace

TEST_CASE("obstacles: distances are those of their surfaces", "[contact]") {
    CHECK(find_obstacle_distance(make(a_plane), a_plane.point + 0.7 * a_plane.normal).distance ==
          Approx(0.7).epsilon(1e-14));
    const Obstacle sphere = make(SphereShape{{0.5, false}, Vec3(1, 0, 0)});
    CHECK(find_obstacle_distance(sphere, Vec3(1, 2, 0)).distance == Approx(1.5).epsilon(1e-14));
    const Obstacle hollow = make(SphereShape{{0.5, true}, Vec3(1, 0, 0)});
    CHECK(find_obstacle_distance(hollow, Vec3(1, 0.2, 0)).distance == Approx(0.3).epsilon(1e-14));
    const Obstacle capsule = make(CylinderShape{{0.5, false}, Vec3(0, 0, 0), Vec3(1, 0, 0)});
    CHECK(find_obstacle_distance(capsule, Vec3(0.5, 2, 0)).distance == Approx(1.5).epsilon(1e-14));
    CHECK(find_obstacle_distance(capsule, Vec3(4, 4, 0)).distance == Approx(4.5).epsilon(1e-14));
    const Obstacle pipe = make(CylinderShape{{0.5, true}, Vec3(0, 0, 0), Vec3(1, 0, 0)});
    CHECK(find_obstacle_distance(pipe, Vec3(4, 0.1, 0)).distance == Approx(0.4).epsilon(1e-14));
    SECTION("a ring's from its circle, but for the error of its pieces") {
        const Vec3 at = 2.7 * Vec3(std::cos(2.0), std::sin(2.0), 0.0);
        CHECK(find_obstacle_distance(a_ring(0.3, false), at).distance == Approx(0.4).epsilon(1e-9));
        CHECK(find_obstacle_distance(a_ring(1.0, true), at).distance == Approx(0.3).epsilon(1e-9));
    }
    SECTION("beyond the ends a hollow tube is straight") {
        CHECK(find_obstacle_distance(a_ring(1.0, true), Vec3(2.2, -5.0, 0.0)).distance ==
              Approx(0.8).epsilon(1e-12));
    }
}

TEST_CASE("obstacles: the normal and the curvature are derivatives of the distance", "[contact]") {
    RandomValues random(3);
    for (const Obstacle& obstacle : all_obstacles()) {
        for (int sample = 0; sample < 20; ++sample) {
            const Vec3 point = random.vector(1.2) + Vec3(0.4, 0.3, 0.2);
            if ((point - find_obstacle_distance(obstacle, point).position).norm() < 0.1) continue;
            const ObstacleDistance found = find_obstacle_distance(obstacle, point);
            Vec3 gradient;
            Mat3 curvature;
            for (int i = 0; i < 3; ++i) {
                const auto moved = [&](double amount) {
                    return find_obstacle_distance(obstacle, point + amount * Vec3::Unit(i));
                };
                gradient[i] = differentiate([&](double x) { return moved(x).distance; }, 1e-4);
                curvature.col(i) = differentiate([&](double x) { return Vec3(moved(x).normal); }, 1e-4);
            }
            INFO(obstacle.shape.index() << " hollow " << obstacle.is_hollow() << " at " << point.transpose());
            CHECK(relative_difference(found.normal, gradient) < 1e-7);
            CHECK((found.curvature - curvature).norm() < 1e-5);
        }
    }
}

TEST_CASE("obstacles: a moved one sees what the point sees from it", "[contact]") {
    Obstacle obstacle = a_ring(0.3, false);
    obstacle.motion =
        ObstacleMotion{TimeVector(Vec3(0.1, 0.2, 0.3)), TimeVector(Vec3(0.3, -0.4, 0.5)), Vec3(1, 0, 0)};
    const ObstaclePlacement placement = place_obstacle(obstacle, 1.0);
    const Vec3 point(0.4, 0.9, 0.2);
    CHECK(relative_difference(placement.from_start(placement.to_start(point)), point) < 1e-14);
    const Mat3 turn = exp_matrix(Vec3(0.3, -0.4, 0.5));
    const Vec3 expected = turn * (Vec3(2, 0, 0) - Vec3(1, 0, 0)) + Vec3(1.1, 0.2, 0.3);
    CHECK(relative_difference(placement.from_start(Vec3(2, 0, 0)), expected) < 1e-14);
    const ObstacleDistance found = find_obstacle_distance(obstacle, placement, point);
    const double step = 1e-6;
    CHECK(find_obstacle_distance(obstacle, placement, point + step * found.normal).distance -
              found.distance ==
          Approx(step).epsilon(1e-6));
}

TEST_CASE("obstacles: a free motion keeps a tenth of the gap all along", "[contact]") {
    RandomValues random(5);
    int stopped = 0;
    for (const Obstacle& obstacle : all_obstacles()) {
        for (int sample = 0; sample < 300; ++sample) {
            const double radius = 0.05;
            const Vec3 from = random.vector(2.5);
            const Vec3 to = from + random.vector(4.0);
            const double gap = find_obstacle_distance(obstacle, from).distance - radius;
            if (gap <= 0.0) continue;
            const FreeMotion free = find_free_motion(obstacle, radius, from, to);
            CHECK(free.gap == Approx(gap).epsilon(1e-12));
            REQUIRE(free.fraction > 0.0);
            REQUIRE(free.fraction <= 1.0);
            double least = gap;
            double beyond = gap;
            for (int i = 0; i <= 200; ++i) {
                const double t = i / 200.0;
                const double here =
                    find_obstacle_distance(obstacle, from + t * (to - from)).distance - radius;
                if (t <= free.fraction) least = std::min(least, here);
                beyond = std::min(beyond, here);
            }
            CHECK(least >= 0.1 * gap * (1.0 - 1e-9));
            if (free.fraction < 1.0) {
                ++stopped;
                // It stops because something is near: hollows and bends are bounded roughly.
                CHECK(beyond < 0.2 * gap);
            }
        }
    }
    CHECK(stopped > 100);
}
