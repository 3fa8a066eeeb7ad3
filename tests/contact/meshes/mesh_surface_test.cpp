#include "contact/meshes/mesh_surface.hpp"

#include <cmath>
#include <numeric>

#include "contact/meshes.hpp"
#include "contact/meshes/triangle_energy.hpp"
#include "tools/catch.hpp"
#include "tools/difference.hpp"
#include "tools/random_values.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

MeshSurface surface_of(const TriangleMesh& mesh) {
    std::vector<int> all(mesh.triangles.size());
    std::iota(all.begin(), all.end(), 0);
    return {mesh, all};
}

// ∫ of −W′(u)/π over a triangle, by halving it.
struct Integral {
    Vec3 point;
    double radius, skin;

    double kernel(const Vec3& y) const {
        const double w = skin * (2.0 * radius + skin);
        const double v = ((point - y).squaredNorm() - radius * radius) / w;
        return v >= 1.0 ? 0.0 : (1.0 - v) * (1.0 - v) * (1.0 + 2.0 * v) / (v * v * w * M_PI);
    }
    double rule(const Vec3& a, const Vec3& b, const Vec3& c) const {
        return 0.5 * (b - a).cross(c - a).norm() *
               (kernel(0.5 * (a + b)) + kernel(0.5 * (b + c)) + kernel(0.5 * (c + a))) / 3.0;
    }
    double over(const Vec3& a, const Vec3& b, const Vec3& c, double rough, int depth = 0) const {
        const Vec3 ab = 0.5 * (a + b), bc = 0.5 * (b + c), ca = 0.5 * (c + a);
        const double parts[4] = {rule(a, ab, ca), rule(ab, b, bc), rule(ca, bc, c), rule(ab, bc, ca)};
        const double fine = parts[0] + parts[1] + parts[2] + parts[3];
        if (depth == 12 || (depth > 6 && std::abs(fine - rough) < 1e-9)) return fine;
        return over(a, ab, ca, parts[0], depth + 1) + over(ab, b, bc, parts[1], depth + 1) +
               over(ca, bc, c, parts[2], depth + 1) + over(ab, bc, ca, parts[3], depth + 1);
    }
};

constexpr double radius = 1.0;
constexpr double skin = 0.05;

// A triangle, and a point within its skin: above it, beside an edge, off a corner, or nearly in its plane.
struct Pose {
    Triangle triangle;
    Vec3 point;
};
Pose find_pose(RandomValues& random, int kind) {
    while (true) {
        const double size = std::pow(10.0, random.number(-1.5, 0.5));
        const Triangle triangle =
            make_triangle(random.vector(size), random.vector(size), random.vector(size));
        double s = random.number(0.0, 1.0), t = random.number(0.0, 1.0 - s);
        if (kind > 0) t = 0.0;
        if (kind == 2) s = 0.0;
        const auto& [a, b, c] = triangle.corners;
        Vec3 away = random.direction();
        if (kind == 0) away = triangle.normal;
        if (kind == 3)
            away = (away - away.dot(triangle.normal) * triangle.normal + random.vector(1e-3)).normalized();
        const Vec3 point = a + s * (b - a) + t * (c - a) + random.number(radius, radius + skin) * away;
        const double gap = find_on_triangle(triangle, point).distance - radius;
        if (gap > 0.02 * skin && gap < 0.6 * skin) return {triangle, point};
    }
}

Vec3 slopes_of(const Nearness& value) { return Vec3(value.slopes.data()); }

Mat3 curvatures_of(const Nearness& value) {
    const auto& c = value.curvatures;
    Mat3 matrix;
    matrix << c[0], c[1], c[2], c[1], c[3], c[4], c[2], c[4], c[5];
    return matrix;
}

}  // namespace

TEST_CASE("The nearness of a triangle is its integral", "[contact]") {
    RandomValues random(1);
    for (int sample = 0; sample < 40; ++sample) {
        const auto [triangle, point] = find_pose(random, sample % 4);
        const auto& [a, b, c] = triangle.corners;
        const double expected = Integral{point, radius, skin}.over(a, b, c, 0.0);
        INFO("sample " << sample);
        CHECK(compute_nearness(triangle, point, radius, skin).value ==
              Approx(expected).epsilon(1e-4).margin(1e-6));
    }
}

TEST_CASE("Slopes and curvatures of the nearness are its derivatives", "[contact]") {
    RandomValues random(2);
    for (int sample = 0; sample < 400; ++sample) {
        const auto [triangle, point] = find_pose(random, sample % 4);
        const double gap = find_on_triangle(triangle, point).distance - radius;
        const Nearness found = compute_nearness(triangle, point, radius, skin);
        if (found.value < 1e-8) continue;
        Vec3 slopes;
        Mat3 curvatures;
        for (int i = 0; i < 3; ++i) {
            const auto moved = [&](double amount) {
                return compute_nearness(triangle, point + amount * Vec3::Unit(i), radius, skin);
            };
            slopes[i] = differentiate([&](double x) { return moved(x).value; }, 1e-3 * gap);
            curvatures.col(i) = differentiate([&](double x) { return slopes_of(moved(x)); }, 1e-3 * gap);
        }
        INFO("sample " << sample << " gap " << gap << " nearness " << found.value);
        CHECK((slopes_of(found) - slopes).norm() < 1e-5 * found.value / gap);
        CHECK((curvatures_of(found) - curvatures).norm() < 1e-5 * found.value / (gap * gap));
    }
}

TEST_CASE("Triangles of a plane are the plane, over edges and corners too", "[contact]") {
    const TriangleMesh floor = make_floor(4.0, 13);
    const MeshSurface surface = surface_of(floor);
    RandomValues random(3);
    for (int sample = 0; sample < 300; ++sample) {
        Vec3 point(
            random.number(-2.0, 2.0), random.number(-2.0, 2.0), radius + skin * random.number(0.001, 0.95));
        if (sample % 3 == 0) point.x() = std::round(point.x());  // over an edge, or a corner
        if (sample % 6 == 0) point.y() = point.x();
        const ObstacleDistance found = surface.find_distance(point, radius, skin);
        INFO(point.transpose());
        CHECK(found.distance == Approx(point.z()).epsilon(1e-13));
        CHECK((found.slope * found.normal - Vec3::UnitZ()).norm() < 1e-10);
        CHECK(found.curvature.norm() < 1e-7);
    }
}

TEST_CASE("The closest point of a mesh is that of all its triangles", "[contact]") {
    const TriangleMesh soup = make_soup(300, 4);
    const MeshSurface surface = surface_of(soup);
    RandomValues random(5);
    for (int sample = 0; sample < 300; ++sample) {
        const Vec3 point = random.vector(3.0);
        double least = std::numeric_limits<double>::infinity();
        for (const std::array<int, 3>& corners : soup.triangles) {
            const auto at = [&](std::size_t i) {
                return soup.positions[static_cast<std::size_t>(corners[i])];
            };
            least = std::min(least, find_on_triangle(make_triangle(at(0), at(1), at(2)), point).distance);
        }
        const MeshSurface::Closest closest = surface.find_closest(point);
        CHECK(closest.point.distance == least);
        CHECK((point - closest.point.position).norm() == Approx(least).epsilon(1e-12));
        CHECK(surface.find_closest(point, 0.999 * least).triangle == -1);
        CHECK(surface.find_closest(point, 1.001 * least).triangle == closest.triangle);
    }
}

TEST_CASE("No point of a triangle is closer than the closest one", "[contact]") {
    RandomValues random(6);
    for (int sample = 0; sample < 200; ++sample) {
        const Triangle triangle = make_triangle(random.vector(), random.vector(), random.vector());
        const auto& [a, b, c] = triangle.corners;
        const Vec3 point = random.vector(2.0);
        const ClosestOnTriangle closest = find_on_triangle(triangle, point);
        double least = std::numeric_limits<double>::infinity();
        constexpr int parts = 200;
        for (int i = 0; i <= parts; ++i)
            for (int j = 0; i + j <= parts; ++j)
                least = std::min(least, (a + (b - a) * i / parts + (c - a) * j / parts - point).norm());
        CHECK(closest.distance <= least + 1e-12);
        CHECK(closest.distance >= least - 0.02);
    }
}

TEST_CASE("The normal and the curvature of a mesh are derivatives of its distance", "[contact]") {
    const TriangleMesh soup = make_soup(60, 7);
    const MeshSurface surface = surface_of(soup);
    RandomValues random(8);
    constexpr double ball = 0.2, range = 0.1;
    int within = 0, beyond = 0;
    for (int sample = 0; sample < 3000; ++sample) {
        const Vec3 point = random.vector(2.0);
        const double gap = surface.find_closest(point).point.distance - ball;
        if (gap < 0.02 * range || gap > 2.0 * range) continue;
        const ObstacleDistance found = surface.find_distance(point, ball, range);
        (gap < range ? within : beyond) += 1;
        Vec3 gradient;
        Mat3 curvature;
        const double step = 1e-4 * gap;
        const auto moved = [&](int axis, double amount) {
            return surface.find_distance(point + amount * Vec3::Unit(axis), ball, range);
        };
        bool is_kink = false;  // of the distance beyond the skin, or where it starts
        for (int i = 0; i < 3; ++i) {
            gradient[i] = differentiate([&](double x) { return moved(i, x).distance; }, step);
            curvature.col(i) =
                differentiate([&](double x) { return Vec3(moved(i, x).slope * moved(i, x).normal); }, step);
            is_kink = is_kink || (gap > 0.8 * range &&
                                  (moved(i, 3.0 * step).normal - moved(i, -3.0 * step).normal).norm() > 1e-3);
        }
        if (is_kink || found.distance > ball + 0.9 * range) continue;
        INFO("sample " << sample << " gap " << gap);
        CHECK((found.slope * found.normal - gradient).norm() < 1e-5 * found.slope);
        CHECK((found.curvature - curvature).norm() < 1e-4 * (found.curvature.norm() + 1.0 / gap));
    }
    CHECK(within > 20);
    CHECK(beyond > 20);
}

TEST_CASE("Within the skin a gap goes to nothing only where the surface is met", "[contact]") {
    // Off a face, an edge and a corner of a cube.
    const TriangleMesh cube = make_cube(2.0);
    for (const Vec3& away : {Vec3(0.0, 0.1, 1.0), Vec3(0.0, 1.0, 1.0), Vec3(1.0, 1.0, 1.0)}) {
        double before = skin;
        for (const double part : {0.9, 0.5, 0.1, 1e-2, 1e-4}) {
            Vec3 point = Vec3(1.0, 1.0, 1.0).cwiseProduct(away.cwiseSign());
            if (away.x() == 0.0) point.x() = 0.3;
            if (away.y() == 0.1) point.y() = 0.1;
            Vec3 direction = away;
            if (away.y() == 0.1) direction = Vec3::UnitZ();
            point += (radius + part * skin) * direction.normalized();
            const double gap = surface_of(cube).find_distance(point, radius, skin).distance - radius;
            INFO(away.transpose() << ", " << part);
            CHECK(gap > 0.0);
            CHECK(gap < before);
            before = gap;
        }
    }
}

TEST_CASE("A free motion against a mesh keeps a tenth of the gap all along", "[contact]") {
    const TriangleMesh soup = make_soup(40, 9);
    const MeshSurface surface = surface_of(soup);
    RandomValues random(10);
    int stopped = 0;
    for (int sample = 0; sample < 2000; ++sample) {
        const double ball = 0.05;
        const Vec3 from = random.vector(2.5);
        const Vec3 to = from + random.vector(sample % 2 == 0 ? 4.0 : 0.1);
        const double gap = surface.find_closest(from).point.distance - ball;
        if (gap <= 0.0) continue;
        const FreeMotion free = surface.find_free_motion(ball, from, to);
        REQUIRE(free.fraction > 0.0);
        REQUIRE(free.fraction <= 1.0);
        double least = gap, beyond = gap;
        for (int i = 0; i <= 200; ++i) {
            const double t = i / 200.0;
            const double here = surface.find_closest(from + t * (to - from)).point.distance - ball;
            if (t <= free.fraction) least = std::min(least, here);
            if (t <= free.fraction + 0.01) beyond = std::min(beyond, here);
        }
        CHECK(least >= 0.1 * gap * (1.0 - 1e-9));
        if (free.fraction < 1.0) {
            ++stopped;
            CHECK(beyond < 0.2 * gap);
        }
    }
    CHECK(stopped > 100);
}

TEST_CASE("A ball that slides along a mesh goes all the way", "[contact]") {
    const MeshSurface surface = surface_of(make_floor(4.0, 13));
    const FreeMotion free = surface.find_free_motion(0.5, Vec3(-1.5, 0.3, 0.5001), Vec3(1.5, 0.1, 0.5001));
    CHECK(free.fraction == 1.0);
    CHECK(free.gap == Approx(1e-4).epsilon(1e-9));
}

TEST_CASE("Sharp edges part a mesh into few surfaces", "[contact]") {
    TriangleMesh cube = make_cube(1.0);
    CHECK(split_at_sharp_edges(cube).size() == 3);  // opposite sides are far from each other
    cube.feature_angle = 1.6;
    CHECK(split_at_sharp_edges(cube).size() == 1);
    TriangleMesh tube = make_cylinder(0.5, -1.0, 1.0, 36, 4);
    tube.feature_angle = 0.2;
    CHECK(split_at_sharp_edges(tube).size() == 1);
    tube.feature_angle = 0.1;
    CHECK(split_at_sharp_edges(tube).size() == 2);
    TriangleMesh groove = make_groove(1.0, 2.0, 2);
    CHECK(split_at_sharp_edges(groove).size() == 2);
}

TEST_CASE("Places are close enough that no edge comes between them", "[contact]") {
    constexpr double r = 0.1, range = 0.002;
    for (const int facets : {4, 12, 40, 200}) {
        const TriangleMesh mesh = make_cylinder(0.5, -5.0, 5.0, facets, 1);
        const double spacing = find_mesh_spacing(mesh, r, range);
        const MeshSurface surface = surface_of(mesh);
        // A straight line across the cylinder, over an edge and next to it.
        for (const double turn : {0.0, 0.3, 0.5}) {
            const double angle = M_PI / 2.0 + turn * 2.0 * M_PI / facets;
            const double height = 0.5 + r;
            const auto distance = [&](double s) {
                return surface
                    .find_closest(Vec3(height * std::cos(angle) - s * std::sin(angle),
                                       height * std::sin(angle) + s * std::cos(angle),
                                       0.3))
                    .point.distance;
            };
            double nearest = 1.0;
            for (int i = -500; i <= 500; ++i) nearest = std::min(nearest, distance(i * spacing / 500.0));
            double nearest_place = 1.0;
            for (const double shift : {0.0, 0.25, 0.5, 0.75}) {
                double here = 1.0;
                for (int i = -2; i <= 2; ++i) here = std::min(here, distance((i + shift) * spacing));
                nearest_place = shift == 0.0 ? here : std::max(nearest_place, here);
            }
            INFO(facets << " facets, turned by " << turn);
            CHECK(nearest_place - nearest < 0.25 * range);
        }
    }
}
