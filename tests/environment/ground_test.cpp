#include "environment/ground.hpp"

#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

Seabed make_slope() {
    Seabed seabed;
    seabed.point = Vec3(1, 2, -3);
    seabed.normal = Vec3(2, -1, 2) / 3.0;
    return seabed;
}

// Heights of z = xy/10 − 2x + y at the corners, on a grid of uneven steps.
double bilinear(double x, double y) { return 0.1 * x * y - 2.0 * x + y; }
Seabed make_grid() {
    GroundGrid grid{{-1, 0, 2, 7}, {0, 3, 4}, {}};
    for (const double y : grid.y) {
        for (const double x : grid.x) grid.z.push_back(bilinear(x, y));
    }
    Seabed seabed;
    seabed.grid = grid;
    return seabed;
}

// Gap and normal follow their gradients.
void check_gradients(const Seabed& seabed, const Vec3& place) {
    INFO(place.transpose());
    const GroundAt at = find_ground(seabed, place);
    const double h = 1e-5;
    CHECK(at.normal.norm() == Approx(1.0).epsilon(1e-15));
    for (int j = 0; j < 3; ++j) {
        const GroundAt after = find_ground(seabed, place + h * Vec3::Unit(j));
        const GroundAt before = find_ground(seabed, place - h * Vec3::Unit(j));
        CHECK(at.gap_gradient[j] == Approx((after.gap - before.gap) / (2 * h)).margin(1e-9));
        CHECK((at.normal_gradient.col(j) - (after.normal - before.normal) / (2 * h)).norm() < 1e-9);
    }
}

}  // namespace

TEST_CASE("The gap above a plane is the distance from it", "[environment]") {
    const Seabed slope = make_slope();
    const GroundAt ground = find_ground(slope, slope.point + 5.0 * slope.normal + 7.0 * Vec3(1, 2, 0));
    CHECK(ground.gap == Approx(5.0).epsilon(1e-15));
    CHECK(ground.normal == slope.normal);
    check_gradients(slope, Vec3(4, -3, 8));
}

TEST_CASE("Between its lines a grid is bilinear", "[environment]") {
    const Seabed seabed = make_grid();
    for (const Vec3& place : {Vec3(-0.5, 1, 2), Vec3(1, 2.5, -40), Vec3(6.9, 3.9, 3), Vec3(0, 3, 1)}) {
        INFO(place.transpose());
        const GroundAt ground = find_ground(seabed, place);
        const Vec3 upright(2.0 - 0.1 * place[1], -1.0 - 0.1 * place[0], 1.0);
        CHECK((ground.normal - upright.normalized()).norm() < 1e-14);
        CHECK(ground.gap ==
              Approx((place[2] - bilinear(place[0], place[1])) / upright.norm()).epsilon(1e-14));
    }
    // Every corner has its own height.
    const GroundGrid& grid = *seabed.grid;
    for (const double y : grid.y) {
        for (const double x : grid.x) {
            CHECK(find_ground(seabed, {x, y, bilinear(x, y)}).gap == Approx(0.0).margin(1e-14));
        }
    }
}

TEST_CASE("The gradients of the ground are those of gap and normal", "[environment]") {
    const Seabed seabed = make_grid();
    for (const Vec3& place : {Vec3(-0.5, 1, 2),
                              Vec3(1, 2.5, -4),
                              Vec3(6.5, 3.5, 3),
                              Vec3(9, 3.5, 3),
                              Vec3(1, -6, 3),
                              Vec3(-3, 5, 3)}) {
        check_gradients(seabed, place);
    }
}

TEST_CASE("Beyond its edges a grid continues as they are", "[environment]") {
    const Seabed seabed = make_grid();
    const GroundAt edge = find_ground(seabed, {20, 3.5, 1});
    CHECK(edge.normal[0] == 0.0);
    CHECK(edge.gap == Approx((1.0 - bilinear(7, 3.5)) * edge.normal[2]).epsilon(1e-14));
    const GroundAt corner = find_ground(seabed, {20, -8, 1});
    CHECK(corner.normal == Vec3::UnitZ());
    CHECK(corner.gap == Approx(1.0 - bilinear(7, 0)).epsilon(1e-14));
}

TEST_CASE("A grid of a plane is that plane", "[environment]") {
    Seabed plane = make_slope(), grid;
    grid.grid = GroundGrid{{-5, 0, 9}, {-4, 4, 6}, {}};
    for (const double y : grid.grid->y) {
        for (const double x : grid.grid->x) {
            grid.grid->z.push_back(-3.0 - (2.0 * (x - 1.0) - (y - 2.0)) / 2.0);
        }
    }
    const Vec3 place(3, 1, 2);
    const GroundAt of_plane = find_ground(plane, place), of_grid = find_ground(grid, place);
    CHECK(of_grid.gap == Approx(of_plane.gap).epsilon(1e-14));
    CHECK((of_grid.normal - of_plane.normal).norm() < 1e-15);
    CHECK((of_grid.gap_gradient - of_plane.gap_gradient).norm() < 1e-15);
}

}  // namespace gxrod::test
