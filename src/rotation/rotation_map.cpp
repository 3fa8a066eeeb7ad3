#include "rotation/rotation_map.hpp"

#include <cmath>
#include <numbers>

#include "rotation/coefficients.hpp"

namespace gxrod {
namespace {

// Below this angle a rotation is the identity within rounding and has no axis of its own.
constexpr double smallest_angle_with_axis = 1e-14;

}  // namespace

Mat3 spin(const Vec3& a) {
    Mat3 result;
    result << 0.0, -a.z(), a.y(), a.z(), 0.0, -a.x(), -a.y(), a.x(), 0.0;
    return result;
}

Vec3 axial(const Mat3& A) { return 0.5 * Vec3(A(2, 1) - A(1, 2), A(0, 2) - A(2, 0), A(1, 0) - A(0, 1)); }

Mat3 exp_matrix(const Vec3& phi) { return exp_quaternion(phi).toRotationMatrix(); }

Quat exp_quaternion(const Vec3& phi) {
    const double half = 0.5 * phi.norm();
    const Vec3 vector = (0.5 * coefficients::a(half)) * phi;
    return Quat(std::cos(half), vector.x(), vector.y(), vector.z());
}

// The matrix goes to the quaternion whose largest component is at least ½: from the trace and the skew part
// (3.5) below 120°, from the symmetric part (3.12) above. Each component then has an error of a few
// roundings.
Vec3 log(const Mat3& Lambda) { return log(Quat(Lambda)); }

Vec3 log(const Quat& q) {
    const double sign = q.w() < 0.0 ? -1.0 : 1.0;
    const double sine = q.vec().norm();
    const double cosine = sign * q.w();
    // atan(s)/s is 1 to 3e-19 here; below 1e-154 the squares in the norm would underflow.
    if (sine < 1e-9 * cosine) return (2.0 / q.w()) * q.vec();
    return (sign * 2.0 * std::atan2(sine, cosine) / sine) * q.vec();
}

Vec3 log_nearest(const Quat& q, const Vec3& guess) {
    constexpr double half_turn = std::numbers::pi;
    constexpr double turn = 2.0 * half_turn;
    Vec3 principal = log(q);
    if ((guess - principal).squaredNorm() < half_turn * half_turn) return principal;
    const bool has_axis = principal.norm() > smallest_angle_with_axis;
    const Vec3 axis = (has_axis ? principal : guess).stableNormalized();
    const double turns = std::round((guess - principal).dot(axis) / turn);
    if (turns == 0.0) return principal;
    return (principal.dot(axis) + turns * turn) * axis;
}

Vec3 compose(const Vec3& second, const Vec3& first) {
    return log(exp_quaternion(second) * exp_quaternion(first));
}

}  // namespace gxrod
