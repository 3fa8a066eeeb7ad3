#include "geometry/natural_spline.hpp"

#include <cmath>

#include "geometry/helix_curve.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

// The spline through points of a sine arch, whose second derivative vanishes at both ends.
double worst_sine_error(int pieces) {
    std::vector<Vec3> points;
    for (int i = 0; i <= pieces; ++i) {
        const double x = M_PI * i / pieces;
        points.emplace_back(x, std::sin(x), 0.0);
    }
    double worst = 0.0;
    for (const Cubic& cubic : compute_natural_spline(points)) {
        for (const double u : {0.25, 0.5, 0.75}) {
            const Vec3 at = cubic.position(u);
            worst = std::max(worst, std::abs(at[1] - std::sin(at[0])));
        }
    }
    return worst;
}

}  // namespace

TEST_CASE("A spline passes its points, smooth to the second derivative, with natural ends", "[geometry]") {
    const std::vector<Vec3> points{
        Vec3(0, 0, 0), Vec3(1, 2, 0), Vec3(3, 1, 1), Vec3(3.5, 1, 4), Vec3(7, -2, 2)};
    const std::vector<Cubic> cubics = compute_natural_spline(points);
    REQUIRE(cubics.size() == 4);
    for (std::size_t i = 0; i < 4; ++i) {
        CHECK((cubics[i].position(0.0) - points[i]).norm() < 1e-15);
        CHECK((cubics[i].position(1.0) - points[i + 1]).norm() < 1e-14);
        if (i == 0) continue;
        const double before = (points[i] - points[i - 1]).norm();
        const double after = (points[i + 1] - points[i]).norm();
        CHECK((cubics[i - 1].slope(1.0) / before - cubics[i].slope(0.0) / after).norm() < 1e-14);
        CHECK((cubics[i - 1].bend(1.0) / (before * before) - cubics[i].bend(0.0) / (after * after)).norm() <
              1e-14);
    }
    CHECK(cubics.front().bend(0.0).norm() < 1e-14);
    CHECK(cubics.back().bend(1.0).norm() < 1e-14);
}

TEST_CASE("A spline of two points is their line", "[geometry]") {
    const std::vector<Vec3> points{Vec3(1, 2, 3), Vec3(4, 6, 3)};
    const PolynomialCurve line(compute_natural_spline(points));
    CHECK(line.length() == Approx(5.0).epsilon(1e-15));
    CHECK((line.position(2.5) - Vec3(2.5, 4, 3)).norm() < 1e-15);
}

TEST_CASE("A spline nears a smooth curve with the fourth power of its spacing", "[geometry]") {
    const double coarse = worst_sine_error(16);
    const double fine = worst_sine_error(32);
    CHECK(std::log2(coarse / fine) == Approx(4.0).margin(0.2));
    CHECK(fine < 2e-6);
}

TEST_CASE("Axes carried along a spline through a helix turn as along the helix", "[geometry]") {
    const HelixCurve helix({Vec3(1, 0, 0), Vec3::UnitZ(), Vec3(1, 0, 0), 4.0 * M_PI, 3.0});
    std::vector<Vec3> points;
    for (int i = 0; i <= 256; ++i) points.push_back(helix.position(helix.length() * i / 256.0));
    const PolynomialCurve spline(compute_natural_spline(points));
    CHECK(spline.length() == Approx(helix.length()).epsilon(1e-6));
    // Away from the ends, where a natural spline is straight and the helix is not.
    const double from = 0.25, to = 0.75;
    const auto turn = [&](const Curve& curve) -> Quat {
        const double length = curve.length();
        return curve.transport(to * length) * curve.transport(from * length).conjugate();
    };
    CHECK(turn(spline).angularDistance(turn(helix)) < 1e-5);
}

}  // namespace gxrod::test
