#include "geometry/helix_curve.hpp"

#include <cmath>

#include "rotation/rotation_map.hpp"

namespace gxrod {

HelixCurve::HelixCurve(const HelixShape& shape)
    : shape_(shape),
      across_(shape.axis.cross(shape.radius)),
      length_(std::hypot(shape.angle * shape.radius.norm(), shape.rise)) {}

Vec3 HelixCurve::position(double s) const {
    const double fraction = s / length_;
    const double half = 0.5 * fraction * shape_.angle;
    // From the start, not from the axis, which can be far away: cos φ − 1 = −2 sin²(φ/2).
    return shape_.start + 2.0 * std::sin(half) * (std::cos(half) * across_ - std::sin(half) * shape_.radius) +
           fraction * shape_.rise * shape_.axis;
}

Vec3 HelixCurve::tangent(double s) const {
    const double phi = s / length_ * shape_.angle;
    const Vec3 slope =
        shape_.angle * (std::cos(phi) * across_ - std::sin(phi) * shape_.radius) + shape_.rise * shape_.axis;
    return slope.normalized();
}

Quat HelixCurve::transport(double s) const {
    const double fraction = s / length_;
    const double torsion_angle = fraction * shape_.angle * shape_.rise / length_;
    return exp_quaternion(fraction * shape_.angle * shape_.axis) *
           exp_quaternion(-torsion_angle * tangent(0.0));
}

// The tangent leans towards the axis and so turns less than the radius does.
double HelixCurve::turn(double s) const {
    const double lean = std::abs(shape_.angle) * shape_.radius.norm() / length_;
    return s / length_ * std::abs(shape_.angle) * lean;
}

}  // namespace gxrod
