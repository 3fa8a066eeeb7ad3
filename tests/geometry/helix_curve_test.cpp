#include "geometry/helix_curve.hpp"

#include <random>

#include "geometry/curve_samples.hpp"
#include "rotation/rotation_map.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

// Radius 2 about z through the origin, from (2, 0, 0).
HelixShape make_shape(double angle, double rise) {
    return {Vec3(2, 0, 0), Vec3::UnitZ(), Vec3(2, 0, 0), angle, rise};
}

}  // namespace

TEST_CASE("Arcs and helices are curves by arc length", "[geometry]") {
    for (const double angle : {0.1, 2.0, -3.0, 2.0 * M_PI, 20.0, -30.0}) {
        for (const double rise : {0.0, 1.0, -5.0, 60.0}) {
            INFO(angle << " " << rise);
            check_curve(HelixCurve(make_shape(angle, rise)));
        }
    }
}

TEST_CASE("An arc has the length, points and tangents of a circle", "[geometry]") {
    const HelixCurve arc(make_shape(M_PI, 0.0));
    CHECK(arc.length() == Approx(2.0 * M_PI).epsilon(1e-15));
    CHECK(arc.position(0.0) == Vec3(2, 0, 0));
    CHECK((arc.position(M_PI) - Vec3(0, 2, 0)).norm() < 1e-15);
    CHECK((arc.position(arc.length()) - Vec3(-2, 0, 0)).norm() < 1e-15);
    CHECK((arc.tangent(M_PI) - Vec3(-1, 0, 0)).norm() < 1e-15);
    CHECK((HelixCurve(make_shape(-M_PI / 2.0, 0.0)).position(M_PI) - Vec3(0, -2, 0)).norm() < 1e-15);
}

TEST_CASE("A small angle of a large circle keeps its digits", "[geometry]") {
    const double radius = 1e10;
    const HelixCurve arc({Vec3::Zero(), Vec3::UnitZ(), Vec3(0, -radius, 0), 1e-10, 0.0});
    CHECK(arc.length() == Approx(1.0).epsilon(1e-15));
    CHECK(arc.position(1.0)[0] == Approx(1.0).epsilon(1e-15));
    CHECK(arc.position(1.0)[1] == Approx(0.5e-10).epsilon(1e-12));
}

TEST_CASE("A helix is right-handed if angle and rise have one sign", "[geometry]") {
    // Of a right-handed helix (r′ × r″)·r‴ is positive.
    const auto handedness = [](double angle, double rise) {
        const HelixCurve helix(make_shape(angle, rise));
        const double h = 1e-2 * helix.length();
        const auto t = [&](double s) { return helix.tangent(s); };
        const double s = 0.5 * helix.length();
        const Vec3 second = (t(s + h) - t(s - h)) / (2 * h);
        const Vec3 third = (t(s + h) - 2.0 * t(s) + t(s - h)) / (h * h);
        return t(s).cross(second).dot(third);
    };
    CHECK(handedness(5.0, 3.0) > 0.0);
    CHECK(handedness(-5.0, -3.0) > 0.0);
    CHECK(handedness(-5.0, 3.0) < 0.0);
    CHECK(handedness(5.0, -3.0) < 0.0);
}

TEST_CASE("Axes carried along a helix lag its own frame by torsion times length", "[geometry]") {
    const double angle = 7.0, rise = 3.0, radius = 2.0;
    const HelixCurve helix(make_shape(angle, rise));
    // κ = R/c², τ = p/c² with p = rise/angle and c² = R² + p².
    const double p = rise / angle;
    const double torsion = p / (radius * radius + p * p);
    for (const double fraction : {0.2, 0.5, 1.0}) {
        const double s = fraction * helix.length();
        // Normal and binormal at the start and at s; the normal points to the axis.
        const Vec3 normal(-1, 0, 0);
        const double phi = fraction * angle;
        const Vec3 normal_at_s(-std::cos(phi), -std::sin(phi), 0);
        const Vec3 binormal_at_s = helix.tangent(s).cross(normal_at_s);
        const Vec3 carried = helix.transport(s) * normal;
        const double behind = torsion * s;
        const Vec3 expected = std::cos(behind) * normal_at_s - std::sin(behind) * binormal_at_s;
        CHECK((carried - expected).norm() < 1e-14);
    }
}

TEST_CASE("The closed form of a helix's transport solves its differential equation", "[geometry]") {
    const HelixCurve helix({Vec3(1, 2, 3), Vec3(2, -1, 2) / 3.0, Vec3(1, 2, 0) * 0.3, 4.0, 1.5});
    const Mat3 integrated = integrate_transport(helix, 0.9 * helix.length());
    CHECK((helix.transport(0.9 * helix.length()).toRotationMatrix() - integrated).norm() < 1e-6);
}

}  // namespace gxrod::test
