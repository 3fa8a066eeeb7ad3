#include "rotation/half_rotation.hpp"

namespace gxrod {

namespace {

// What fill_small does, for larger angles. τ is known.
void fill_large(const Eigen::Quaterniond& q, HalfRotation<double>& rotation) {
    const double sine = q.vec().norm();
    const double h = std::atan2(sine, q.w());
    const double z = 4.0 * h * h;
    rotation.x = h / sine;
    rotation.Phi = (2.0 * rotation.x) * q.vec();
    rotation.y = (1.0 - rotation.x) / z;
    rotation.t = 0.5 * sine / (1.0 + q.w()) / h;
    rotation.x1 = rotation.x * (1.0 - h * q.w() / sine) / z;
    rotation.y1 = -(rotation.x1 + 2.0 * rotation.y) / z;
    rotation.t1 = (0.25 * (1.0 + rotation.tau.squaredNorm()) - rotation.t) / z;
}

}  // namespace

HalfRotation<double> split_rotation(Eigen::Quaterniond q) {
    if (q.w() < 0.0) q.coeffs() = -q.coeffs();
    HalfRotation<double> rotation;
    split_half(q, rotation);
    if (q.vec().squaredNorm() < half_rotation::largest_square) {
        fill_small(q, rotation);
    } else {
        fill_large(q, rotation);
    }
    return rotation;
}

void fill_lane(const double* quaternion, int stride, double* values) {
    const HalfRotation<double> rotation =
        split_rotation({quaternion[3 * stride], quaternion[0], quaternion[stride], quaternion[2 * stride]});
    const auto& [Phi, tau, half, x, y, t, x1, y1, t1] = rotation;
    for (const double value : {Phi[0], Phi[1], Phi[2], x, y, t, x1, y1, t1}) {
        *values = value;
        values += stride;
    }
}

}  // namespace gxrod
