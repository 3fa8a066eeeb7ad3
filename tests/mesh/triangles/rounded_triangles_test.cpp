#include "mesh/triangles/rounded_triangles.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "contact/meshes.hpp"
#include "mesh/triangles/triangle_examination.hpp"
#include "tools/catch.hpp"

using namespace gxrod;

namespace {

// Two caps of a cylinder about z, each a fan about its middle.
TriangleMesh close(TriangleMesh tube, int facets) {
    const int last = static_cast<int>(tube.positions.size()) - facets;
    for (const int first : {0, last}) {
        const double height = tube.positions[static_cast<std::size_t>(first)].z();
        const int middle = add_position(Vec3(0, 0, height), tube);
        for (int j = 0; j < facets; ++j) {
            const int a = first + j, b = first + (j + 1) % facets;
            tube.triangles.push_back(first == 0 ? std::array{middle, b, a} : std::array{middle, a, b});
        }
    }
    tube.numbers.resize(tube.triangles.size());
    std::iota(tube.numbers.begin(), tube.numbers.end(), 1);
    return tube;
}

// A quarter of a torus of radius 1 about z, as thick as 0.2, and how far a point is from it.
TriangleMesh make_bend(int around, int along) {
    TriangleMesh mesh = make_grid(along, around, [&](int i, int j) {
        const double turn = 0.5 * M_PI * i / along, angle = 2.0 * M_PI * j / around;
        const double out = 1.0 + 0.2 * std::cos(angle);
        return Vec3(out * std::cos(turn), out * std::sin(turn), 0.2 * std::sin(angle));
    });
    return mesh;
}
double off_bend(const Vec3& x) { return std::abs(std::hypot(std::hypot(x.x(), x.y()) - 1.0, x.z()) - 0.2); }

double find_farthest(const TriangleMesh& mesh, const std::function<double(const Vec3&)>& distance) {
    double farthest = 0.0;
    for (const auto& corners : mesh.triangles)
        for (const int corner : corners)
            farthest = std::max(farthest, distance(mesh.positions[static_cast<std::size_t>(corner)]));
    return farthest;
}

}  // namespace

TEST_CASE("Facets of a cylinder are rounded onto it", "[mesh]") {
    constexpr double radius = 0.5;
    for (const int facets : {12, 24}) {
        TriangleMesh flat = make_cylinder(radius, 0.0, 2.0, facets, 3);
        flat.feature_angle = 0.6;
        const RoundedTriangles round = round_triangles(flat);
        const double half = M_PI / facets;
        const double depth = radius * (1.0 - std::cos(half));
        // A parabola over the chord has the height R sin² h/(2 cos h).
        const double off = 0.5 * radius * std::pow(std::sin(half), 2) / std::cos(half) - depth;
        CHECK(find_farthest(round.mesh, [&](const Vec3& x) {
                  return std::abs(std::hypot(x.x(), x.y()) - radius);
              }) < 1.01 * off);
        CHECK(off < 0.03 * depth);
        const int pieces = facets == 12 ? 5 : 2;
        const double middle = static_cast<double>(pieces / 2) / pieces;
        CHECK(round.depth == Approx(4.0 * middle * (1.0 - middle) * (depth + off)).epsilon(1e-12));
        const TriangleExamination found = examine_triangles(round.mesh);
        CHECK(found.greatest_turn == Approx(2.0 * half / pieces).epsilon(0.05));
        CHECK(found.parts == 1);
        CHECK(found.open_edges.size() == round.mesh.open_edges);
        CHECK(found.flipped.empty());
        CHECK(round.mesh.triangles.size() == flat.triangles.size() * pieces * pieces);
        // Each piece has the number of its facet.
        CHECK(std::ranges::count(round.mesh.numbers, 5) == pieces * pieces);
    }
}

TEST_CASE("Rounding meets a bent tube in the fourth power of its sides", "[mesh]") {
    std::array<double, 2> off{}, off_flat{};
    for (const std::size_t i : {0, 1}) {
        TriangleMesh flat = make_bend(i == 0 ? 16 : 32, i == 0 ? 20 : 40);
        flat.feature_angle = 0.6;
        const RoundedTriangles round = round_triangles(flat);
        // Away from the open ends and the seam, where normals are those of one side.
        off[i] = find_farthest(round.mesh, [](const Vec3& x) {
            const double turn = std::atan2(x.y(), x.x());
            const bool is_inner =
                turn > 0.5 && turn < 1.0 && std::abs(std::atan2(x.z(), std::hypot(x.x(), x.y()) - 1.0)) > 1.0;
            return is_inner ? off_bend(x) : 0.0;
        });
        off_flat[i] = round.depth;
    }
    CHECK(off[0] < 0.05 * off_flat[0]);
    CHECK(off_flat[0] / off_flat[1] == Approx(4.0).epsilon(0.1));
    CHECK(off[0] / off[1] > 8.0);
}

TEST_CASE("Sharp edges stay sharp, and curve with the surfaces that meet there", "[mesh]") {
    constexpr int facets = 24;
    TriangleMesh drum = close(make_cylinder(0.5, 0.0, 2.0, facets, 2), facets);
    drum.feature_angle = 0.6;
    const TriangleExamination before = examine_triangles(drum);
    REQUIRE(before.is_closed());
    const RoundedTriangles round = round_triangles(drum);
    const TriangleExamination after = examine_triangles(round.mesh);
    CHECK(after.is_closed());
    CHECK(after.flipped.empty());
    REQUIRE(after.volume);
    CHECK(*before.volume < 0.99 * M_PI * 0.5);
    // Twice as many facets.
    CHECK(*after.volume == Approx(0.5 * facets * std::sin(M_PI / facets)).epsilon(1e-4));
    CHECK(after.low.z() == 0.0);
    CHECK(after.high.z() == 2.0);
    CHECK(after.greatest_turn == Approx(0.5 * M_PI).epsilon(1e-3));
}

TEST_CASE("What is flat, or sharp all over, is not rounded", "[mesh]") {
    TriangleMesh cube = make_cube(1.0);
    cube.feature_angle = 0.6;
    TriangleMesh floor = make_floor(1.0, 4);
    TriangleMesh fine = make_cylinder(0.5, 0.0, 2.0, 96, 3);
    for (const TriangleMesh& mesh : {cube, floor, fine}) {
        const RoundedTriangles round = round_triangles(mesh);
        CHECK(round.mesh.triangles == mesh.triangles);
        CHECK(round.mesh.positions == mesh.positions);
        CHECK(round.depth == 0.0);
    }
}

TEST_CASE("Rounding does not depend on which way facets are around", "[mesh]") {
    TriangleMesh flat = make_cylinder(0.5, 0.0, 2.0, 16, 3);
    flat.feature_angle = 0.6;
    const RoundedTriangles round = round_triangles(flat);
    for (std::size_t t = 0; t < flat.triangles.size(); t += 3)
        std::swap(flat.triangles[t][0], flat.triangles[t][1]);
    const RoundedTriangles other = round_triangles(flat);
    CHECK(other.depth == Approx(round.depth).epsilon(1e-12));
    REQUIRE(other.mesh.positions.size() == round.mesh.positions.size());
    const auto radius = [](const Vec3& x) { return std::abs(std::hypot(x.x(), x.y()) - 0.5); };
    CHECK(find_farthest(other.mesh, radius) == Approx(find_farthest(round.mesh, radius)).epsilon(1e-9));
}

TEST_CASE("A surface with one side only is rounded but for its seam", "[mesh]") {
    constexpr int pieces = 24;
    TriangleMesh strip = make_grid(pieces, 2, [](int i, int j) {
        const double turn = 2.0 * M_PI * i / pieces, across = 0.2 * (j - 1);
        const double out = 1.0 + across * std::cos(0.5 * turn);
        return Vec3(out * std::cos(turn), out * std::sin(turn), across * std::sin(0.5 * turn));
    });
    // The last row is the first one, the other way around.
    for (auto& corners : strip.triangles)
        for (int& corner : corners)
            if (corner >= 3 * pieces) corner = 2 - (corner - 3 * pieces);
    strip.feature_angle = 0.6;
    const RoundedTriangles round = round_triangles(strip);
    CHECK(round.mesh.triangles.size() > strip.triangles.size());
    const double chord = 1.2 * (1.0 - std::cos(M_PI / pieces));
    CHECK(round.depth < 1.5 * chord);
    CHECK(examine_triangles(round.mesh).parts == 1);
}
