#include "geometry/centreline.hpp"

#include "geometry/helix_curve.hpp"
#include "geometry/line_curve.hpp"
#include "rotation/rotation_map.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

// Two along x, one along y, one along z.
Centreline make_staircase() {
    std::vector<std::unique_ptr<Curve>> pieces;
    pieces.push_back(std::make_unique<LineCurve>(Vec3(0, 0, 0), Vec3(2, 0, 0)));
    pieces.push_back(std::make_unique<LineCurve>(Vec3(2, 0, 0), Vec3(2, 1, 0)));
    pieces.push_back(std::make_unique<LineCurve>(Vec3(2, 1, 0), Vec3(2, 1, 1)));
    return Centreline(std::move(pieces));
}

}  // namespace

TEST_CASE("A centreline has the length, corners and points of its pieces", "[geometry]") {
    const Centreline line = make_staircase();
    CHECK(line.length() == 4.0);
    CHECK(line.corners() == std::vector<double>{0.5, 0.75});
    CHECK(line.start_tangent() == Vec3(1, 0, 0));
    CHECK(line.piece_at(0.0) == 0);
    CHECK(line.piece_at(0.49) == 0);
    CHECK(line.piece_at(0.51) == 1);
    CHECK(line.piece_at(1.0) == 2);
    CHECK((line.position(0, 0.25) - Vec3(1, 0, 0)).norm() < 1e-15);
    CHECK((line.position(1, 0.625) - Vec3(2, 0.5, 0)).norm() < 1e-15);
    // Corners are at their very points, from either side.
    for (const std::size_t piece : {0, 1}) CHECK(line.position(piece, 0.5) == Vec3(2, 0, 0));
    for (const std::size_t piece : {1, 2}) CHECK(line.position(piece, 0.75) == Vec3(2, 1, 0));
    CHECK(line.position(2, 1.0) == Vec3(2, 1, 1));
}

TEST_CASE("Axes turn in a corner by the smallest rotation between the tangents", "[geometry]") {
    const Centreline line = make_staircase();
    CHECK(line.transport(0, 0.5).angularDistance(Quat::Identity()) < 1e-15);
    const Quat first = exp_quaternion({0, 0, M_PI / 2});
    CHECK(line.transport(1, 0.5).angularDistance(first) < 1e-15);
    CHECK(line.transport(1, 0.75).angularDistance(first) < 1e-15);
    CHECK(line.transport(2, 0.75).angularDistance(exp_quaternion({M_PI / 2, 0, 0}) * first) < 1e-15);
}

TEST_CASE("Axes are carried on from a curved piece", "[geometry]") {
    std::vector<std::unique_ptr<Curve>> pieces;
    pieces.push_back(
        std::make_unique<HelixCurve>(HelixShape{Vec3(1, 0, 0), Vec3::UnitZ(), Vec3(1, 0, 0), M_PI / 2, 0.0}));
    pieces.push_back(std::make_unique<LineCurve>(Vec3(0, 1, 0), Vec3(0, 1, 3)));
    const Centreline line(std::move(pieces));
    const Quat about_z = exp_quaternion({0, 0, M_PI / 2});
    CHECK(line.transport(0, line.corners()[0]).angularDistance(about_z) < 1e-15);
    // From −x to z.
    CHECK(line.transport(1, 1.0).angularDistance(exp_quaternion({0, M_PI / 2, 0}) * about_z) < 1e-15);
}

}  // namespace gxrod::test
