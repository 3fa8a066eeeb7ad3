#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstddef>

#include "rotation/series.hpp"

// A rotation exp(Φ) in two halves, with the derivatives that an element with two nodes needs. Real is double,
// or several of them that are worked on at once.
//
// Legend: θ = |Φ| ≤ π, z = θ², h = θ/2; x = h/sin h, y = (1 − x)/z, t = tan(θ/4)/θ; x1, y1, t1 are 2 d/dz of
// these, so that ∇x = x1 Φ. X = x I + y Φ Φᵀ takes the difference of the spins of both ends, seen from
// half-way, to δΦ; τ = t Φ has δτ = (t I + t1 Φ Φᵀ) δΦ.
namespace gxrod {

template <class Real>
struct HalfRotation {
    Eigen::Matrix<Real, 3, 1> Phi, tau;
    Eigen::Quaternion<Real> half;  // exp(Φ/2)
    Real x, y, t, x1, y1, t1;
};

namespace half_rotation {

// h/sin h = Σ a_k h^2k: its product with sin h/h = Σ (−1)^k h^2k/(2k + 1)! is 1. In z: a_k/4^k.
template <std::size_t terms>
constexpr std::array<double, terms> make_x_series() {
    std::array<long double, terms> a{1.0L};
    for (std::size_t k = 1; k < terms; ++k) {
        long double factor = 1.0L;
        for (std::size_t j = 1; j <= k; ++j) {
            factor /= -static_cast<long double>(2 * j * (2 * j + 1));
            a[k] -= factor * a[k - j];
        }
    }
    std::array<double, terms> factors{};
    long double scale = 1.0L;
    for (std::size_t k = 0; k < terms; ++k, scale /= 4.0L) factors[k] = static_cast<double>(scale * a[k]);
    return factors;
}

// tan u = u Σ c_k u^2k from tan′ = 1 + tan², u = θ/4. In z: c_k/(4 · 16^k).
template <std::size_t terms>
constexpr std::array<double, terms> make_t_series() {
    std::array<long double, terms> c{1.0L};
    for (std::size_t k = 1; k < terms; ++k) {
        for (std::size_t j = 0; j < k; ++j) c[k] += c[j] * c[k - 1 - j];
        c[k] /= static_cast<long double>(2 * k + 1);
    }
    std::array<double, terms> factors{};
    long double scale = 0.25L;
    for (std::size_t k = 0; k < terms; ++k, scale /= 16.0L) factors[k] = static_cast<double>(scale * c[k]);
    return factors;
}

// asin s/s in s².
template <std::size_t terms>
constexpr std::array<double, terms> make_arcsine_series() {
    std::array<double, terms> factors{};
    long double central = 1.0L;
    for (std::size_t k = 0; k < terms; ++k) {
        factors[k] = static_cast<double>(central / static_cast<long double>(2 * k + 1));
        central *= static_cast<long double>(2 * k + 1) / static_cast<long double>(2 * k + 2);
    }
    return factors;
}

// 2 d/dz.
template <std::size_t terms>
constexpr std::array<double, terms - 1> derive(const std::array<double, terms>& series) {
    std::array<double, terms - 1> factors{};
    for (std::size_t k = 0; k + 1 < terms; ++k) factors[k] = 2.0 * static_cast<double>(k + 1) * series[k + 1];
    return factors;
}

// (1 − Σ)/z.
template <std::size_t terms>
constexpr std::array<double, terms - 1> take_from_one(const std::array<double, terms>& series) {
    std::array<double, terms - 1> factors{};
    for (std::size_t k = 0; k + 1 < terms; ++k) factors[k] = -series[k + 1];
    return factors;
}

// Where sin² h is below this (θ < 0.51) the series are used, with a truncation below 1e-17.
inline constexpr double largest_square = 0.0625;
inline constexpr auto arcsine_series = make_arcsine_series<14>();
inline constexpr auto x_series = make_x_series<12>();
inline constexpr auto y_series = take_from_one(x_series);
inline constexpr auto x1_series = derive(x_series);
inline constexpr auto y1_series = derive(y_series);
inline constexpr auto t_series = make_t_series<10>();
inline constexpr auto t1_series = derive(t_series);

}  // namespace half_rotation

// Splits exp(Φ), a unit quaternion with w ≥ 0, for θ < 0.51.
template <class Real>
void fill_small(const Eigen::Quaternion<Real>& q, HalfRotation<Real>& rotation) {
    namespace series = half_rotation;
    rotation.x = evaluate_series<Real>(series::arcsine_series, q.vec().squaredNorm());
    rotation.Phi = (Real(2.0) * rotation.x) * q.vec();
    const Real z = rotation.Phi.squaredNorm();
    rotation.y = evaluate_series<Real>(series::y_series, z);
    rotation.t = evaluate_series<Real>(series::t_series, z);
    rotation.x1 = evaluate_series<Real>(series::x1_series, z);
    rotation.y1 = evaluate_series<Real>(series::y1_series, z);
    rotation.t1 = evaluate_series<Real>(series::t1_series, z);
}

// Computes τ and exp(Φ/2) from a unit quaternion with w ≥ 0.
template <class Real>
void split_half(const Eigen::Quaternion<Real>& q, HalfRotation<Real>& rotation) {
    using std::sqrt;
    const Real cosine = sqrt(Real(0.5) * (Real(1.0) + q.w()));  // cos(θ/4)
    rotation.tau = q.vec() / (Real(1.0) + q.w());
    rotation.half.w() = cosine;
    rotation.half.vec() = q.vec() * (Real(0.5) / cosine);
}

// Splits the rotation of a unit quaternion of either sign.
HalfRotation<double> split_rotation(Eigen::Quaterniond q);

// Computes Φ, x, y, t, x1, y1, t1 of a unit quaternion (x, y, z, w) with w ≥ 0, for kernels that work on
// several rotations at once. `stride` separates consecutive values of a rotation in both arrays.
inline constexpr int half_rotation_values = 9;
void fill_lane(const double* quaternion, int stride, double* values);

}  // namespace gxrod
