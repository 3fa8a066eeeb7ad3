#include "model/body_moments.hpp"

#include <algorithm>
#include <cmath>

#include "numerics/eigenvalues.hpp"

namespace gxrod {
namespace {

constexpr double round_off = 1e-9;
// A number of two digits, 10 at least, is rounded by a half.
constexpr double rounding = 0.05;

bool exceed_sum(const Vec3& moments, double tolerance) {
    return moments[2] > moments[0] + moments[1] + tolerance * moments.cwiseAbs().sum();
}

}  // namespace

bool exceed_sum(const Vec3& moments) { return exceed_sum(moments, round_off); }

bool is_beyond_rounding(const Vec3& moments) { return exceed_sum(moments, rounding); }

Cuboid find_cuboid(double mass, const Mat3& inertia) {
    // A diagonal tensor keeps its order, so that equal moments do not turn the cuboid.
    const bool is_diagonal = inertia.isDiagonal(1e-12);
    const SymmetricEigen principal = find_symmetric_eigen(inertia);
    Mat3 axes = is_diagonal ? Mat3(Mat3::Identity()) : Mat3(principal.vectors);
    if (axes.determinant() < 0.0) axes.col(2) *= -1.0;
    const Vec3 moments = is_diagonal ? Vec3(inertia.diagonal()) : Vec3(principal.values);
    Cuboid cuboid{Quat(axes)};
    if (!(mass > 0.0)) return cuboid;
    for (int i = 0; i < 3; ++i)
        cuboid.half_sizes[i] = std::sqrt(std::max(0.0, 1.5 / mass * (moments.sum() - 2.0 * moments[i])));
    return cuboid;
}

}  // namespace gxrod
