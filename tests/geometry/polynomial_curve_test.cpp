#include "geometry/polynomial_curve.hpp"

#include "geometry/curve_samples.hpp"
#include "rotation/rotation_map.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

const Cubic twisted_cubic{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}};
const Cubic parabola{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3::Zero()}};

PolynomialCurve curve_of(const Cubic& cubic) { return PolynomialCurve({&cubic, 1}); }

// Of y = x² from 0 to x.
double parabola_length(double x) {
    const double slope = 2.0 * x;
    return 0.25 * (slope * std::sqrt(1.0 + slope * slope) + std::asinh(slope));
}

}  // namespace

TEST_CASE("Polynomials pass through the points that they interpolate", "[geometry]") {
    const std::vector<Vec3> points{Vec3(1, 2, 3), Vec3(4, 0, 1), Vec3(-2, 5, 0.5), Vec3(0.1, 7, 9)};
    for (std::size_t count = 2; count <= 4; ++count) {
        const Cubic cubic = interpolate({points.data(), count});
        for (std::size_t i = 0; i < count; ++i) {
            const double u = static_cast<double>(i) / static_cast<double>(count - 1);
            CHECK((cubic.position(u) - points[i]).norm() < 1e-13);
        }
        if (count < 4) CHECK(cubic.c[3].isZero(0.0));
        if (count < 3) CHECK(cubic.c[2].isZero(0.0));
    }
}

TEST_CASE("Polynomials are curves by arc length", "[geometry]") {
    check_curve(curve_of(twisted_cubic));
    check_curve(curve_of(parabola));
    // Turns by more than half a circle.
    check_curve(curve_of({{Vec3(0, 0, 0), Vec3(9, 0, 0), Vec3(-18, 3, 0), Vec3(9, 1, 1)}}));
}

TEST_CASE("The length of a parabola is that of the closed form, to round-off", "[geometry]") {
    const PolynomialCurve curve = curve_of(parabola);
    CHECK(curve.length() == Approx(parabola_length(1.0)).epsilon(2e-15));
    for (const double x : {1e-6, 0.1, 0.37, 0.5, 0.93}) {
        CHECK(curve.arc_length_at(x) == Approx(parabola_length(x)).epsilon(1e-14));
        CHECK((curve.position(parabola_length(x)) - Vec3(x, x * x, 0)).norm() < 1e-15);
    }
    // A long thin one, sharply bent in its middle.
    const Cubic sharp{{Vec3(-1, 1e4, 0), Vec3(2, -4e4, 0), Vec3(0, 4e4, 0), Vec3::Zero()}};
    const double expected = 2.0 * 1e-4 * parabola_length(1e4);
    CHECK(curve_of(sharp).length() == Approx(expected).epsilon(1e-14));
}

TEST_CASE("Axes carried along a plane curve turn about the plane's normal", "[geometry]") {
    const PolynomialCurve curve = curve_of(parabola);
    for (const double x : {0.1, 0.5, 1.0}) {
        const Quat expected = exp_quaternion({0, 0, std::atan(2.0 * x)});
        CHECK(curve.transport(curve.arc_length_at(x)).angularDistance(expected) < 1e-14);
    }
}

TEST_CASE("The quadrature of a polynomial's transport solves its differential equation", "[geometry]") {
    const PolynomialCurve curve = curve_of(twisted_cubic);
    for (const double fraction : {0.4, 0.95}) {
        const double s = fraction * curve.length();
        CHECK((curve.transport(s).toRotationMatrix() - integrate_transport(curve, s)).norm() < 1e-6);
    }
}

TEST_CASE("A curve's transport does not depend on how it is cut into polynomials", "[geometry]") {
    // Halves of the twisted cubic by their own parameter.
    const auto part = [](double first, double width) {
        return Cubic{{twisted_cubic.position(first),
                      width * twisted_cubic.slope(first),
                      0.5 * width * width * twisted_cubic.bend(first),
                      width * width * width * twisted_cubic.c[3]}};
    };
    const std::vector<Cubic> parts{part(0.0, 0.3), part(0.3, 0.2), part(0.5, 0.5)};
    const PolynomialCurve cut(parts);
    const PolynomialCurve whole = curve_of(twisted_cubic);
    CHECK(cut.length() == Approx(whole.length()).epsilon(1e-15));
    for (int i = 0; i <= 20; ++i) {
        const double s = whole.length() * i / 20.0;
        CHECK((cut.position(s) - whole.position(s)).norm() < 1e-14);
        CHECK(cut.transport(s).angularDistance(whole.transport(s)) < 1e-14);
    }
    CHECK(cut.arc_length_at(1.5) == Approx(whole.arc_length_at(0.4)).epsilon(1e-14));
}

TEST_CASE("A curve that stops or turns back has a fold", "[geometry]") {
    CHECK_FALSE(find_fold({&twisted_cubic, 1}));
    CHECK_FALSE(find_fold({&parabola, 1}));
    const Cubic back{{Vec3::Zero(), Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3::Zero()}};
    REQUIRE(find_fold({&back, 1}));
    CHECK(*find_fold({&back, 1}) == Approx(0.5).margin(0.02));
    const Cubic cusp{{Vec3::Zero(), Vec3::Zero(), Vec3(0, 1, 0), Vec3(1, 0, 0)}};
    CHECK(find_fold({&cusp, 1}));
    const std::vector<Cubic> both{parabola, back};
    CHECK(*find_fold(both) == Approx(1.5).margin(0.02));
}

}  // namespace gxrod::test
