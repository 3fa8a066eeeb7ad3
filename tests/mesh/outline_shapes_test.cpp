#include "mesh/outline_shapes.hpp"

#include <cmath>
#include <map>
#include <numbers>

#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

constexpr double pi = std::numbers::pi;

// The volume that triangles enclose, by the divergence theorem; positive if their normals point outside.
double volume(const BodyOutline& outline) {
    double sum = 0.0;
    for (const std::array<int, 3>& corners : outline.triangles) {
        const auto at = [&](std::size_t i) { return outline.points[static_cast<std::size_t>(corners[i])]; };
        sum += at(0).dot(at(1).cross(at(2))) / 6.0;
    }
    return sum;
}

// Whether each edge has two triangles, which pass it in opposite directions.
bool is_closed(const BodyOutline& outline) {
    std::map<std::array<int, 2>, int> passed;
    for (const std::array<int, 3>& corners : outline.triangles)
        for (std::size_t i = 0; i < 3; ++i) ++passed[{corners[i], corners[(i + 1) % 3]}];
    for (const auto& [edge, count] : passed)
        if (count != 1 || !passed.contains({edge[1], edge[0]})) return false;
    return !passed.empty();
}

}  // namespace

TEST_CASE("A box of an outline has its volume, its place and twelve edges", "[mesh]") {
    BodyOutline outline;
    add_box({1, 2, 3}, {{7, 0, 0}, Quat(Eigen::AngleAxisd(pi / 2, Vec3::UnitZ()))}, outline);
    CHECK(volume(outline) == Approx(48));
    CHECK(is_closed(outline));
    CHECK(outline.lines.size() == 12);
    for (const Vec3& point : outline.points) {
        CHECK(std::abs(point.x() - 7) == Approx(2));
        CHECK(std::abs(point.y()) == Approx(1));
    }
}

TEST_CASE("Round shapes of an outline are prisms and pyramids of 24 sides", "[mesh]") {
    // Of a polygon inscribed in the unit circle.
    const double area = 12 * std::sin(pi / 12);
    BodyOutline cylinder;
    add_cylinder({1, 1, 1}, {1, 5, 1}, 2, cylinder);
    CHECK(volume(cylinder) == Approx(4 * area * 4));
    CHECK(is_closed(cylinder));
    CHECK(cylinder.lines.size() == 2 * 24 + 4);

    BodyOutline sphere, capsule;
    add_capsule({3, 2, 1}, {3, 2, 1}, 0.5, sphere);
    CHECK(is_closed(sphere));
    const double ball = 4 * pi / 3 * 0.125;
    CHECK(volume(sphere) < ball);
    CHECK(volume(sphere) > 0.95 * ball);
    for (const Vec3& point : sphere.points) CHECK((point - Vec3(3, 2, 1)).norm() == Approx(0.5));

    add_capsule({0, 0, 0}, {-4, 0, 0}, 0.5, capsule);
    CHECK(is_closed(capsule));
    CHECK(volume(capsule) - volume(sphere) == Approx(0.25 * area * 4));
}

TEST_CASE("Edges of a mesh that are open or sharp become lines", "[mesh]") {
    // A square of two triangles, and one that goes on from an edge at an angle.
    const auto lines_at = [](double angle) {
        TriangleMesh mesh;
        mesh.positions = {
            {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1 + std::cos(angle), 0, std::sin(angle)}};
        mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {1, 4, 2}};
        BodyOutline outline;
        add_lines({{9, 9, 9}, {8, 8, 8}}, outline);
        add_triangles(mesh, {}, outline);
        CHECK(outline.triangles.back() == std::array{3, 6, 4});
        return outline.lines.size() - 1;
    };
    CHECK(lines_at(0.1) == 5);
    CHECK(lines_at(pi / 6 - 1e-6) == 5);
    CHECK(lines_at(pi / 6 + 1e-6) == 6);
}

}  // namespace gxrod::test
