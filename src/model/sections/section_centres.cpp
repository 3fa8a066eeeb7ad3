#include "model/sections/section_centres.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace gxrod {
namespace {

using Mat2 = Eigen::Matrix2d;

// Axes closer than this to y and z, or a matrix that is as near to a multiple of 1, is round-off.
constexpr double round_off = 1e-12;
// Of offsets, compared with the size of the section.
constexpr double least_offset = 1e-9;

// Of a symmetric matrix of the components y, z.
PrincipalAxes find_axes(const Mat2& matrix) {
    const double mean = 0.5 * (matrix(0, 0) + matrix(1, 1));
    const double half = 0.5 * (matrix(0, 0) - matrix(1, 1));
    const double off = 0.5 * (matrix(0, 1) + matrix(1, 0));
    if (std::abs(off) <= round_off * std::abs(mean)) return {0.0, matrix(0, 0), matrix(1, 1)};
    // The nearer to y is the larger or the smaller one.
    const double sign = half < 0.0 ? -1.0 : 1.0;
    const double radius = sign * std::hypot(half, off);
    return {0.5 * std::atan2(sign * off, sign * half), mean + radius, mean - radius};
}

}  // namespace

SectionCentres::SectionCentres(const Mat6& stiffness, const Mat6& mass) {
    // Strains by resultants, scaled so that units do not matter.
    const Vec6 scale = stiffness.diagonal().cwiseSqrt().cwiseInverse();
    const Mat6 scaled = scale.asDiagonal() * stiffness * scale.asDiagonal();
    const Mat6 S = scale.asDiagonal() * Mat6(scaled.llt().solve(Mat6::Identity())) * scale.asDiagonal();
    // A force N at (y, z) has the moments (z N, −y N) about y and z.
    const Mat2 by_moments = S.bottomRightCorner<2, 2>();
    const Mat2 bending = by_moments.inverse();
    const Eigen::Vector2d moments = -bending * S.block<2, 1>(4, 0);
    tension_centre_ = {-moments[1], moments[0]};
    // Forces Qy, Qz at (y, z) have the torque y Qz − z Qy.
    shear_centre_ = {-S(3, 2) / S(3, 3), S(3, 1) / S(3, 3)};
    bending_ = find_axes(bending);
    size_ = std::sqrt(std::max(bending_.about_y, bending_.about_z) / stiffness(0, 0));
    const double m = mass(0, 0);
    if (!(m > 0.0)) return;
    const SectionPoint d(-mass(0, 5) / m, mass(0, 4) / m);
    centre_of_mass_ = d;
    // J less m(d² 1 − d dᵀ).
    const Mat2 about_node = mass.bottomRightCorner<2, 2>();
    inertia_ = find_axes(about_node - m * (d.squaredNorm() * Mat2::Identity() - d * d.transpose()));
}

SectionPoint SectionCentres::clean(const SectionPoint& point) const {
    return point.unaryExpr([&](double x) { return std::abs(x) <= least_offset * size_ ? 0.0 : x; });
}

bool SectionCentres::are_apart() const {
    const auto is_apart = [&](const SectionPoint& point) { return !clean(point).isZero(0.0); };
    return bending_.turn != 0.0 || is_apart(tension_centre_) || is_apart(shear_centre_) ||
           (centre_of_mass_ && is_apart(*centre_of_mass_));
}

}  // namespace gxrod
