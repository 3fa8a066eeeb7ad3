#pragma once

#include <Eigen/Geometry>

#include "rotation/series.hpp"
#include "rotation/tangent_map_formulas.hpp"

// exp(φ), T(φ) and derivatives of T (tangent_map.hpp) for rotations of less than 1 rad, by series alone, so
// that several rotations can be computed at once: Real is double, or several of them. For the coefficients
// see coefficients.hpp.
namespace gxrod {

template <class Real>
class SmallRotation {
  public:
    using Vec3 = Eigen::Matrix<Real, 3, 1>;
    using Mat3 = Eigen::Matrix<Real, 3, 3>;

    explicit SmallRotation(const Vec3& phi) : phi_(phi) {
        const Real x = phi.squaredNorm();
        a_ = evaluate_series(make_series<1, 0>, x);
        slopes_ = {.a1 = evaluate_series(make_series<1, 1>, x),
                   .b = evaluate_series(make_series<3, 0>, x),
                   .b1 = evaluate_series(make_series<3, 1>, x),
                   .c = evaluate_series(make_series<2, 0>, x),
                   .c1 = evaluate_series(make_series<2, 1>, x)};
    }

    Mat3 exp() const {
        return formulas::compose<Real>(phi_, Real(1.0) - slopes_.c * phi_.squaredNorm(), a_, slopes_.c);
    }
    Mat3 tangent_map() const { return formulas::compose<Real>(phi_, a_, slopes_.c, slopes_.b); }
    // The derivative of T by s where φ has the slope φ′.
    Mat3 tangent_map_slope(const Vec3& phi_prime) const {
        const Real along = phi_.dot(phi_prime);
        const Vec3 b_phi = slopes_.b * phi_;
        return formulas::compose<Real>(phi_, slopes_.a1 * along, slopes_.c1 * along, slopes_.b1 * along) +
               b_phi * phi_prime.transpose() + phi_prime * b_phi.transpose() +
               cross_matrix<Real>(slopes_.c * phi_prime);
    }
    // The derivative of this slope by time where φ has the rate φ° and φ′ the rate φ′°.
    Mat3 tangent_map_slope_rate(const Vec3& phi_prime, const Vec3& phi_rate, const Vec3& slope_rate) const {
        const auto& [a1, b, b1, c, c1] = slopes_;
        const auto [a2, b2, c2] = compute_curvatures();
        const Real p = phi_.dot(phi_prime);
        const Real q = phi_.dot(phi_rate);
        const Real first = phi_prime.dot(phi_rate) + phi_.dot(slope_rate);
        const Vec3 u = p * phi_rate + q * phi_prime;
        const Vec3 g = b1 * u + b * slope_rate;
        const Vec3 b_rate = b * phi_rate;
        const Mat3 half = g * phi_.transpose() + b_rate * phi_prime.transpose();
        return formulas::compose<Real>(
                   phi_, a2 * p * q + a1 * first, c2 * p * q + c1 * first, b2 * p * q + b1 * first) +
               half + half.transpose() + cross_matrix<Real>(c1 * u + c * slope_rate);
    }
    // The derivatives of T(φ) v and of T(φ)ᵀ v by φ at fixed v.
    Mat3 tangent_map_derivative(const Vec3& v) const { return formulas::derive<Real>(phi_, v, slopes_); }
    Mat3 tangent_map_transpose_derivative(const Vec3& v) const {
        const auto& [a1, b, b1, c, c1] = slopes_;
        return formulas::derive<Real>(phi_, v, {a1, b, b1, -c, -c1});
    }
    // The second derivative of u · T(φ) v by φ at fixed u and v; symmetric.
    Mat3 tangent_map_hessian(const Vec3& u, const Vec3& v) const {
        return formulas::derive_twice<Real>(phi_, u, v, slopes_, compute_curvatures());
    }

  private:
    // Truncated below 1e-17 for x ≤ 1.
    template <int offset, int order>
    static constexpr auto make_series = make_alternating_series<offset, order, 11>();

    formulas::Curvatures<Real> compute_curvatures() const {
        const Real x = phi_.squaredNorm();
        return {evaluate_series(make_series<1, 2>, x),
                evaluate_series(make_series<3, 2>, x),
                evaluate_series(make_series<2, 2>, x)};
    }

    Vec3 phi_;
    Real a_;
    formulas::Slopes<Real> slopes_;
};

// The series d = Σ 2 ζ(2j + 2) (x/4π²)^j/4π²; truncated below 1e-17 for x ≤ 1.
constexpr std::array<double, 11> make_small_rotation_series() {
    constexpr std::array<long double, 11> zeta = {1.64493406684822643647L,
                                                  1.08232323371113819152L,
                                                  1.01734306198444913971L,
                                                  1.00407735619794433938L,
                                                  1.00099457512781808534L,
                                                  1.00024608655330804830L,
                                                  1.00006124813505870483L,
                                                  1.00001528225940865187L,
                                                  1.00000381729326499984L,
                                                  1.00000095396203387280L,
                                                  1.00000023845050272773L};
    constexpr long double four_pi_squared = 39.4784176043574344753L;
    std::array<double, 11> factors{};
    long double power = 1.0L / four_pi_squared;
    for (std::size_t j = 0; j < factors.size(); ++j, power /= four_pi_squared)
        factors[j] = static_cast<double>(2.0L * zeta[j] * power);
    return factors;
}

// The series of its derivative.
constexpr std::array<double, 10> make_slope_series(const std::array<double, 11>& series) {
    std::array<double, 10> factors{};
    for (std::size_t j = 0; j < factors.size(); ++j)
        factors[j] = 2.0 * static_cast<double>(j + 1) * series[j + 1];
    return factors;
}

// T(φ)⁻¹ and its derivatives for rotations of less than 1 rad.
template <class Real>
class SmallInverseRotation {
  public:
    using Vec3 = Eigen::Matrix<Real, 3, 1>;
    using Mat3 = Eigen::Matrix<Real, 3, 3>;

    explicit SmallInverseRotation(const Vec3& phi)
        : phi_(phi),
          d_(evaluate_series(series, Real(phi.squaredNorm()))),
          d1_(evaluate_series(slope_series, Real(phi.squaredNorm()))) {}

    Mat3 tangent_map_inverse() const { return formulas::invert<Real>(phi_, d_); }
    // The derivative of T⁻¹ by time where φ has the rate φ°.
    Mat3 tangent_map_inverse_rate(const Vec3& phi_rate) const {
        const Real along = phi_.dot(phi_rate);
        const Real d_rate = d1_ * along;
        const Vec3 d_phi = d_ * phi_;
        return formulas::compose<Real>(
                   phi_, -d_rate * phi_.squaredNorm() - Real(2.0) * d_ * along, Real(0.0), d_rate) +
               d_phi * phi_rate.transpose() + phi_rate * d_phi.transpose() -
               cross_matrix<Real>(Real(0.5) * phi_rate);
    }
    // The derivative of T(φ)⁻ᵀ v by φ at fixed v.
    Mat3 tangent_map_inverse_transpose_derivative(const Vec3& v) const {
        return formulas::derive_inverse<Real>(phi_, v, Real(-1.0), d_, d1_);
    }

  private:
    static constexpr std::array<double, 11> series = make_small_rotation_series();
    static constexpr std::array<double, 10> slope_series = make_slope_series(series);

    Vec3 phi_;
    Real d_, d1_;
};

}  // namespace gxrod
