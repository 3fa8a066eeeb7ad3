#include "cross_section/walls/wall_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "cross_section/walls/sample_walls.hpp"
#include "cross_section/walls/solid_meshes.hpp"
#include "tools/catch.hpp"

using namespace gxrod;

namespace {

using std::numbers::pi;

// A channel of plies with one rounded and one mitred corner.
SampleWalls make_channel(WallSide line = WallSide::middle) {
    return {{.corners = {{{0.1, 0.0}}, {{0.0, 0.0}, 0.02}, {{0.0, 0.15}}, {{0.12, 0.15}}},
             .line = line,
             .layups = {0, 1, 0}},
            {{"flange", {{0, 0.004, 0.3}, {1, 0.002, -0.8}}}, {"web", {{1, 0.001, 0.0}, {0, 0.005, 1.2}}}},
            {make_orthotropic({141e9, 9.8e9, 9.8e9, 6e9, 6e9, 4.8e9, 0.3, 0.3, 0.34}),
             make_isotropic(70e9, 0.33)}};
}

// Takes strains about a point at `shift`, in axes turned by an angle about x, from those of the section.
Mat6 turn_and_shift(double angle, const PlanePoint& shift) {
    Mat6 to_axes = Mat6::Zero();
    const Mat3 R = Eigen::AngleAxisd(angle, Vec3::UnitX()).toRotationMatrix();
    const Vec3 d(0.0, shift.x(), shift.y());
    Mat3 cross;
    cross << 0.0, -d.z(), d.y(), d.z(), 0.0, -d.x(), -d.y(), d.x(), 0.0;
    to_axes.topLeftCorner<3, 3>() = R.transpose();
    to_axes.bottomRightCorner<3, 3>() = R.transpose();
    // Γ′ = Rᵀ(Γ + K × d)
    to_axes.topRightCorner<3, 3>() = -R.transpose() * cross;
    return to_axes;
}

double find_difference(const Mat6& a, const Mat6& b) {
    const Vec6 scale = a.diagonal().cwiseSqrt().cwiseInverse();
    return (scale.asDiagonal() * (a - b) * scale.asDiagonal()).cwiseAbs().maxCoeff();
}

}  // namespace

TEST_CASE("Meshes of walls cover their area, arcs included", "[cross_section]") {
    const SampleWalls box = make_box({0, 90});
    CHECK(compute_area(box.mesh()) == Approx(0.953 * 0.53 - 0.933 * 0.51).epsilon(1e-13));
    const SampleWalls pipe = make_pipe();
    const double arcs = pi * (0.25 - 0.09);
    CHECK(compute_area(pipe.mesh()) == Approx(2.0 * 2.0 * 0.2 + arcs).epsilon(3e-6));
    // Walls of two thicknesses share the corners by the line through both of its points.
    WallOutline outline = box.outline;
    outline.layups = {0, 1, 0, 1};
    const SectionMesh mesh = mesh_walls(outline, {{"thin", {{0, 0.01, 0.0}}}, {"thick", {{0, 0.03, 0.0}}}});
    CHECK(compute_area(mesh) == Approx(0.953 * 0.53 - 0.893 * 0.51).epsilon(1e-13));
}

TEST_CASE("The nodes of a wall lie on its arcs, and t turns with them", "[cross_section]") {
    const SampleWalls pipe = make_pipe();
    const SectionMesh mesh = pipe.mesh();
    double largest = 0.0;
    for (const SectionCell& cell : mesh.cells) {
        REQUIRE(cell.walls.size() == cell.nodes.size());
        for (std::size_t i = 0; i < cell.nodes.size(); ++i) {
            const PlanePoint& at = mesh.nodes[static_cast<std::size_t>(cell.nodes[i])];
            const PlanePoint out = {at.x() - std::clamp(at.x(), -1.0, 1.0), at.y()};
            const double radius = out.norm();
            CHECK(radius > 0.3 - 1e-14);
            CHECK(radius < 0.5 + 1e-14);
            largest = std::max(largest, radius);
            const PlanePoint outwards = std::abs(at.x()) > 1.0 ? out : PlanePoint(0.0, at.y());
            const PlanePoint expected = PlanePoint(-outwards.y(), outwards.x()).normalized();
            CHECK((cell.walls[i] - expected).norm() < 1e-13);
        }
    }
    CHECK(largest > 0.5 - 1e-14);
}

TEST_CASE("Layers of walls are the plies of their layups", "[cross_section]") {
    const SectionMesh mesh = make_channel().mesh();
    REQUIRE(mesh.layers.size() == 4);
    CHECK(mesh.layers[0].name == "flange ply 0");
    CHECK(mesh.layers[1].material == 1);
    CHECK(mesh.layers[2].name == "web ply 0");
    CHECK(mesh.layers[3].fibre_angle == 1.2);
    // The first ply is on the right: outside, in a closed wall.
    const SectionMesh box = make_box({0, 90}).mesh();
    for (const SectionCell& cell : box.cells) {
        for (const int node : cell.nodes) {
            const PlanePoint at = box.nodes[static_cast<std::size_t>(node)].cwiseAbs();
            const double depth = std::min(0.4765 - at.x(), 0.265 - at.y());
            CHECK(std::abs(depth - (cell.layer == 0 ? 0.0025 : 0.0075)) < 0.0025 + 1e-12);
        }
    }
}

TEST_CASE("A wall turned, moved and scaled has the same stiffness in its axes", "[cross_section]") {
    const SampleWalls walls = make_channel();
    const Mat6 K = solve(walls.mesh(), walls.materials).stiffness;
    const double angle = 0.7;
    const PlanePoint shift(0.3, -0.2);
    SampleWalls moved = walls;
    for (WallCorner& corner : moved.outline.corners)
        corner.at = Eigen::Rotation2Dd(angle) * corner.at + shift;
    const Mat6 T = turn_and_shift(angle, shift);
    CHECK(find_difference(solve(moved.mesh(), walls.materials).stiffness, T.transpose() * K * T) < 1e-8);
    for (const double scale : {1e-3, 1e3}) {
        SampleWalls scaled = walls;
        for (WallCorner& corner : scaled.outline.corners) corner = {scale * corner.at, scale * corner.radius};
        for (Layup& layup : scaled.layups) {
            for (Ply& ply : layup.plies) ply.thickness *= scale;
        }
        Vec6 lengths;
        lengths << Vec3::Constant(scale), Vec3::Constant(scale * scale);
        const Mat6 expected = lengths.asDiagonal() * K * lengths.asDiagonal();
        CHECK(find_difference(solve(scaled.mesh(), walls.materials).stiffness, expected) < 1e-9);
    }
}

TEST_CASE("A wall walked the other way has its plies in reverse and their angles too", "[cross_section]") {
    const SampleWalls walls = make_channel(WallSide::right);
    SampleWalls reversed = make_channel(WallSide::left);
    std::ranges::reverse(reversed.outline.corners);
    std::ranges::reverse(reversed.outline.layups);
    for (Layup& layup : reversed.layups) {
        std::ranges::reverse(layup.plies);
        for (Ply& ply : layup.plies) ply.fibre_angle = -ply.fibre_angle;
    }
    CHECK(find_difference(solve(walls.mesh(), walls.materials).stiffness,
                          solve(reversed.mesh(), walls.materials).stiffness) < 1e-10);
}

TEST_CASE("The line of a wall is its right side, its middle or its left side", "[cross_section]") {
    SampleWalls middle = make_box({0, 45});
    middle.outline.line = WallSide::middle;
    SampleWalls right = middle, left = middle;
    right.outline.line = WallSide::right;
    left.outline.line = WallSide::left;
    for (std::size_t i = 0; i < 4; ++i) {
        const PlanePoint diagonal = middle.outline.corners[i].at.cwiseSign();
        right.outline.corners[i].at += 0.005 * diagonal;
        left.outline.corners[i].at -= 0.005 * diagonal;
    }
    const Mat6 K = solve(middle.mesh(), middle.materials).stiffness;
    CHECK(find_difference(K, solve(right.mesh(), middle.materials).stiffness) < 1e-10);
    CHECK(find_difference(K, solve(left.mesh(), middle.materials).stiffness) < 1e-10);
}

TEST_CASE("Sides with other plies meet by rows that both share", "[cross_section]") {
    // One ply, and the same wall in unequal plies of the same material and angle.
    SampleWalls box = make_box({20});
    box.layups = {{"whole", {{0, 0.03, 20 * degree}}},
                  {"cut", {{0, 0.004, 20 * degree}, {0, 0.017, 20 * degree}, {0, 0.009, 20 * degree}}}};
    const Mat6 K = solve(box.mesh(), box.materials).stiffness;
    box.outline.layups = {0, 1, 1, 0};
    const SectionMesh mesh = box.mesh();
    CHECK(mesh.layers.size() == 4);
    CHECK(find_difference(K, solve(mesh, box.materials).stiffness) < 2e-5);
}

TEST_CASE("A mesh of a tube by walls and the tube's own agree", "[cross_section]") {
    // Four right angles whose radii take the sides whole.
    const WallOutline outline{
        .corners = {{{-0.1, -0.1}, 0.1}, {{0.1, -0.1}, 0.1}, {{0.1, 0.1}, 0.1}, {{-0.1, 0.1}, 0.1}},
        .is_closed = true,
        .line = WallSide::right,
        .layups = {0}};
    const Mat6 K =
        solve(mesh_walls(outline, {{"steel", {{0, 0.01, 0.0}}}}), {make_isotropic(100.0, 0.2)}).stiffness;
    CHECK(find_worst_entry(
              K, {{1, 1, .5969026042}, {2, 2, .1249250954}, {4, 4, .002250820237}, {5, 5, .002700984284}}) <
          1e-5);
}

TEST_CASE("Meshes of circles, tubes and rectangles have the closed forms", "[cross_section]") {
    const double nu = 0.3, n = nu / (1.0 + nu), G = 1.0, E = 2.0 * (1.0 + nu);
    const std::vector<ElasticMaterial> steel{make_isotropic(E, nu)};
    const auto check = [&](const auto& mesh, std::initializer_list<MatrixEntry> entries) {
        CHECK(find_worst_entry(solve(mesh({}), steel).stiffness, entries) < 1e-5);
        // Order 4 with finer elements: what is left is round-off and the singular corners of a rectangle.
        CHECK(find_worst_entry(solve(mesh({.order = 4, .refinement = 1.5}), steel).stiffness, entries) <
              2e-7);
    };
    check(
        [](const SolidMeshSettings& settings) { return mesh_circle(1.0, settings); },
        {{1, 1, E * pi}, {2, 2, G * pi * 6.0 / (7.0 + n * n)}, {4, 4, 0.5 * G * pi}, {5, 5, 0.25 * E * pi}});
    check([](const SolidMeshSettings& settings) { return mesh_rectangle(2.0, 1.0, settings); },
          {{1, 1, 2.0 * E},
           {2, 2, 2.0 * .832941726831447},
           {3, 3, 2.0 * .784441925213463},
           {4, 4, .457363354255479},
           {5, 5, E / 6.0},
           {6, 6, E * 2.0 / 3.0}});
    const double m = 1.0 / 3.0;
    const double k = 6.0 / (7.0 + n * n + (20.0 - 4.0 * n * n) * m * m / ((1.0 + m * m) * (1.0 + m * m)));
    check([](const SolidMeshSettings& settings) { return mesh_tube(0.3, 0.1, settings); },
          {{1, 1, E * pi * 0.08},
           {2, 2, k * G * pi * 0.08},
           {3, 3, k * G * pi * 0.08},
           {4, 4, 0.5 * pi * (0.0081 - 0.0001)},
           {5, 5, 0.25 * E * pi * (0.0081 - 0.0001)}});
}
