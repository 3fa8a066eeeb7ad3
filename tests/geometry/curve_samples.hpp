#pragma once

#include <cmath>

#include "geometry/curve.hpp"
#include "tools/catch.hpp"

// What every curve must satisfy.
namespace gxrod::test {

// Positions are by arc length, tangents their derivative, transports take tangents along.
inline void check_curve(const Curve& curve) {
    const double h = 1e-5 * curve.length();
    CHECK(curve.transport(0.0).angularDistance(Quat::Identity()) < 1e-15);
    for (int i = 1; i < 20; ++i) {
        const double s = curve.length() * i / 20.0;
        INFO("s = " << s);
        const Vec3 slope = (curve.position(s + h) - curve.position(s - h)) / (2.0 * h);
        CHECK((slope - curve.tangent(s)).norm() < 1e-7);
        CHECK(std::abs(curve.tangent(s).norm() - 1.0) < 1e-15);
        CHECK((curve.transport(s) * curve.tangent(0.0) - curve.tangent(s)).norm() < 2e-15);
    }
}

// The rotation that carries axes from the start to s, by the differential equation of carried axes,
// y′ = −(y·t′) t, integrated by many steps of the classical Runge-Kutta scheme.
inline Mat3 integrate_transport(const Curve& curve, double s) {
    constexpr int steps = 1000;
    const double h = s / steps;
    const double d = 1e-4 * s;
    const auto bend = [&](double at) -> Vec3 {
        const double left = std::max(at - d, 0.0), right = std::min(at + d, curve.length());
        // Of fourth order inside, from four tangents.
        if (at - 2 * d > 0.0 && at + 2 * d < curve.length()) {
            return (8.0 * (curve.tangent(at + d) - curve.tangent(at - d)) -
                    (curve.tangent(at + 2 * d) - curve.tangent(at - 2 * d))) /
                   (12.0 * d);
        }
        return (curve.tangent(right) - curve.tangent(left)) / (right - left);
    };
    Mat3 axes = Mat3::Identity();
    const auto rate = [&](double at, const Mat3& x) -> Mat3 {
        // t × t′ is the angular velocity of carried axes.
        const Vec3 w = curve.tangent(at).cross(bend(at));
        Mat3 spin;
        spin << 0, -w[2], w[1], w[2], 0, -w[0], -w[1], w[0], 0;
        return spin * x;
    };
    for (int i = 0; i < steps; ++i) {
        const double at = i * h;
        const Mat3 k1 = rate(at, axes);
        const Mat3 k2 = rate(at + 0.5 * h, axes + 0.5 * h * k1);
        const Mat3 k3 = rate(at + 0.5 * h, axes + 0.5 * h * k2);
        const Mat3 k4 = rate(at + h, axes + h * k3);
        axes += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
    }
    return axes;
}

}  // namespace gxrod::test
