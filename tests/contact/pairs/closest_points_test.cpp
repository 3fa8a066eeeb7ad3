#include "contact/pairs/closest_points.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

// The least squared distance of |r + s A − t B|² over t for a given s is convex in s: by thirds.
double find_least_distance(const Segment& a, const Segment& b) {
    const auto distance = [&](double s) {
        const Vec3 x = a.at(s), B = b.end - b.start;
        const double t =
            B.squaredNorm() > 0.0 ? std::clamp(B.dot(x - b.start) / B.squaredNorm(), 0.0, 1.0) : 0.0;
        return (x - b.at(t)).norm();
    };
    double low = 0.0, high = 1.0;
    for (int k = 0; k < 90; ++k) {
        const double left = low + (high - low) / 3.0, right = high - (high - low) / 3.0;
        (distance(left) > distance(right) ? low : high) = distance(left) > distance(right) ? left : right;
    }
    return std::min({distance(0.5 * (low + high)), distance(0.0), distance(1.0)});
}

void check_closest_points(const Segment& a, const Segment& b, double tolerance = 1e-12) {
    const ClosestPoints found = find_closest_points(a, b);
    CHECK((found.s >= 0.0 && found.s <= 1.0 && found.t >= 0.0 && found.t <= 1.0));
    CHECK((a.at(found.s) - b.at(found.t) - found.offset).norm() < 1e-14);
    CHECK(found.offset.norm() == Approx(found.distance).margin(1e-15));
    CHECK(std::abs(found.distance - find_least_distance(a, b)) < tolerance);
    const ClosestPoints swapped = find_closest_points(b, a);
    CHECK(std::abs(swapped.distance - found.distance) < tolerance);
}

}  // namespace

TEST_CASE("Closest points of random segments", "[contact]") {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    const auto vector = [&](double scale) {
        const double x = uniform(random), y = uniform(random), z = uniform(random);
        return Vec3(scale * Vec3(x, y, z));
    };
    for (int k = 0; k < 2000; ++k) {
        const Vec3 p = vector(1.0), q = vector(1.0);
        const Vec3 A = vector(k % 3 == 0 ? 0.05 : 1.0);
        // Of every angle, down to parallel to rounding.
        const Vec3 B =
            k % 2 == 0 ? vector(1.0) : Vec3(uniform(random) * A + vector(std::pow(10.0, -(k % 20))));
        INFO(k);
        check_closest_points({p, p + A}, {q, q + B}, 1e-9);
    }
}

TEST_CASE("Closest points of parallel, collinear and vanishing segments", "[contact]") {
    const Vec3 o(0, 0, 0), x(1, 0, 0), y(0, 1, 0);
    check_closest_points({o, x}, {y, y + x});                           // side by side
    check_closest_points({o, x}, {y + 0.3 * x, y + 0.4 * x});           // within
    check_closest_points({o, x}, {y + 2 * x, y + 1.5 * x});             // past the end, reversed
    check_closest_points({o, x}, {1.25 * x, 2 * x});                    // collinear
    check_closest_points({o, x}, {0.5 * x, 2 * x});                     // collinear, overlapping
    check_closest_points({o, x}, {0.3 * x + y, 0.3 * x + y});           // a point
    check_closest_points({o, o}, {y, y});                               // two points
    check_closest_points({o, o}, {o, o});                               // the same point
    check_closest_points({o, x}, {Vec3(0.5, -1, 0), Vec3(0.5, 1, 0)});  // they meet
    const ClosestPoints crossing = find_closest_points({o, 2 * x}, {Vec3(0.5, -1, 0.25), Vec3(0.5, 3, 0.25)});
    CHECK(crossing.s == 0.25);
    CHECK(crossing.t == 0.25);
    CHECK(crossing.distance == 0.25);
    CHECK(crossing.offset == Vec3(0, 0, -0.25));
}

TEST_CASE("Segments are within a distance or not", "[contact]") {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    const auto vector = [&] { return Vec3(uniform(random), uniform(random), uniform(random)); };
    int within = 0;
    for (int k = 0; k < 2000; ++k) {
        const Vec3 p = vector(), q = 2.0 * vector();
        const Segment a{p, p + 0.5 * vector()}, b{q, q + 0.5 * vector()};
        const double distance = find_closest_points(a, b).distance;
        CHECK(are_within(a, b, 1.0) == (distance < 1.0));
        CHECK(are_within(a, b, distance * (1.0 + 1e-12)));
        CHECK_FALSE(are_within(a, b, distance));
        within += distance < 1.0 ? 1 : 0;
    }
    CHECK(within > 200);
    CHECK(within < 1800);
}

}  // namespace gxrod::test
