#include "loads/drag.hpp"

#include <cmath>

namespace gxrod {

Vec3 compute_cross_flow_drag(const Vec3& factors, const Vec3& u) {
    const double across = std::hypot(u.y(), u.z());
    return factors.cwiseProduct(Vec3(std::abs(u.x()), across, across)).cwiseProduct(u);
}

// Zero at rest, where |u| u has the derivative 0.
Mat3 compute_cross_flow_drag_derivative(const Vec3& factors, const Vec3& u) {
    const double across = std::hypot(u.y(), u.z());
    Mat3 derivative = Mat3::Zero();
    derivative(0, 0) = 2.0 * factors.x() * std::abs(u.x());
    if (across == 0.0) return derivative;
    const Eigen::Vector2d n = u.tail<2>();
    derivative.bottomRightCorner<2, 2>() =
        factors.tail<2>().asDiagonal() * (across * Eigen::Matrix2d::Identity() + n * n.transpose() / across);
    return derivative;
}

Vec3 compute_body_drag(const Vec3& factors, const Vec3& u) { return u.norm() * factors.cwiseProduct(u); }

// Zero at rest, where |u| u has the derivative 0.
Mat3 compute_body_drag_derivative(const Vec3& factors, const Vec3& u) {
    const double speed = u.norm();
    if (speed == 0.0) return Mat3::Zero();
    return factors.asDiagonal() * (speed * Mat3::Identity() + u * u.transpose() / speed);
}

}  // namespace gxrod
