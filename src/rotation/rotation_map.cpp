#include "rotation/rotation_map.hpp"

#include <cmath>
#include <numbers>

#include "rotation/half_rotation.hpp"
#include "rotation/series.hpp"

namespace gxrod {
namespace {

// Below this angle a rotation is the identity within rounding and has no axis of its own.
constexpr double smallest_angle_with_axis = 1e-14;

// cos h and sin h/h in h², truncated below 1e-18 where h < 1/2: a third of the time of the functions, and no
// root.
constexpr double largest_series_square = 0.25;
constexpr auto cosine_series = make_alternating_series<0, 0, 8>();
constexpr auto sine_series = make_alternating_series<1, 0, 8>();

}  // namespace

Mat3 spin(const Vec3& a) {
    Mat3 result;
    result << 0.0, -a.z(), a.y(), a.z(), 0.0, -a.x(), -a.y(), a.x(), 0.0;
    return result;
}

Vec3 axial(const Mat3& A) { return 0.5 * Vec3(A(2, 1) - A(1, 2), A(0, 2) - A(2, 0), A(1, 0) - A(0, 1)); }

Mat3 exp_matrix(const Vec3& phi) { return exp_quaternion(phi).toRotationMatrix(); }

Quat exp_quaternion(const Vec3& phi) {
    const double square = 0.25 * phi.squaredNorm();
    double cosine = 0.0, sine_over_half = 0.0;
    if (square < largest_series_square) {
        cosine = evaluate_series(cosine_series, square);
        sine_over_half = evaluate_series(sine_series, square);
    } else {
        const double half = std::sqrt(square);
        cosine = std::cos(half);
        sine_over_half = std::sin(half) / half;
    }
    const Vec3 vector = (0.5 * sine_over_half) * phi;
    return Quat(cosine, vector.x(), vector.y(), vector.z());
}

// The matrix goes to the quaternion whose largest component is at least ½: from the trace and the skew part
// (3.5) below 120°, from the symmetric part (3.12) above. Each component then has an error of a few
// roundings.
Vec3 log(const Mat3& Lambda) { return log(Quat(Lambda)); }

Vec3 log(const Quat& q) {
    const double sign = q.w() < 0.0 ? -1.0 : 1.0;
    const double square = q.vec().squaredNorm();
    if (square < half_rotation::largest_square)
        return (sign * 2.0 * evaluate_series(half_rotation::arcsine_series, square)) * q.vec();
    const double sine = std::sqrt(square);
    return (sign * 2.0 * std::atan2(sine, sign * q.w()) / sine) * q.vec();
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
