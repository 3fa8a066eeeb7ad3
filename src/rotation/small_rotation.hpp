#pragma once

#include <Eigen/Geometry>

#include "rotation/cross_products.hpp"
#include "rotation/series.hpp"

// exp(φ), T(φ) and derivatives of T (tangent_map.hpp) of rotations of less than 1 rad, by series alone, so
// that several can be worked on at once: Real is double, or several of them. The coefficients are those of
// coefficients.hpp.
namespace gxrod {

template <class Real>
class SmallRotation {
  public:
    using Vec3 = Eigen::Matrix<Real, 3, 1>;
    using Mat3 = Eigen::Matrix<Real, 3, 3>;

    explicit SmallRotation(const Vec3& phi) : phi_(phi) {
        const Real x = phi.squaredNorm();
        a_ = evaluate_series(make_series<1, 0>, x);
        b_ = evaluate_series(make_series<3, 0>, x);
        c_ = evaluate_series(make_series<2, 0>, x);
        a1_ = evaluate_series(make_series<1, 1>, x);
        b1_ = evaluate_series(make_series<3, 1>, x);
        c1_ = evaluate_series(make_series<2, 1>, x);
    }

    Mat3 exp() const { return compose(Real(1.0) - c_ * phi_.squaredNorm(), a_, c_); }
    // a I + c [φ]× + b φ ⊗ φ.
    Mat3 tangent_map() const { return compose(a_, c_, b_); }
    // The derivative of T by s where φ has the slope φ′.
    Mat3 tangent_map_slope(const Vec3& phi_prime) const {
        const Real along = phi_.dot(phi_prime);
        const Vec3 b_phi = b_ * phi_;
        return compose(a1_ * along, c1_ * along, b1_ * along) + b_phi * phi_prime.transpose() +
               phi_prime * b_phi.transpose() + cross_matrix<Real>(c_ * phi_prime);
    }
    // Of T(φ) v, and of T(φ)ᵀ v, by φ at fixed v.
    Mat3 tangent_map_derivative(const Vec3& v) const { return derive(v, c_, c1_); }
    Mat3 tangent_map_transpose_derivative(const Vec3& v) const { return derive(v, -c_, -c1_); }
    // The second derivative of u · T(φ) v by φ at fixed u and v; symmetric.
    Mat3 tangent_map_hessian(const Vec3& u, const Vec3& v) const {
        const Real x = phi_.squaredNorm();
        const Vec3 w = v.cross(u);
        const Real s = u.dot(v);
        const Real p = phi_.dot(u);
        const Real q = phi_.dot(v);
        const Real r = phi_.dot(w);
        const Real second = evaluate_series(make_series<1, 2>, x) * s +
                            evaluate_series(make_series<3, 2>, x) * p * q +
                            evaluate_series(make_series<2, 2>, x) * r;
        const Real first = a1_ * s + b1_ * p * q + c1_ * r;
        const Vec3 g = b1_ * (q * u + p * v) + c1_ * w + (Real(0.5) * second) * phi_;
        Mat3 half = phi_ * g.transpose() + (b_ * u) * v.transpose();
        half.diagonal().array() += Real(0.5) * first;
        return half + half.transpose();
    }

  private:
    // Truncated below 1e-17 for x ≤ 1.
    template <int offset, int order>
    static constexpr auto make_series = make_alternating_series<offset, order, 11>();

    // f I + g [φ]× + h φ ⊗ φ.
    Mat3 compose(const Real& f, const Real& g, const Real& h) const {
        Mat3 result = (h * phi_) * phi_.transpose() + cross_matrix<Real>(g * phi_);
        result.diagonal().array() += f;
        return result;
    }
    // Of a v + b (φ · v) φ + c φ × v.
    Mat3 derive(const Vec3& v, const Real& c, const Real& c1) const {
        const Real along = phi_.dot(v);
        const Vec3 gradient_factor = a1_ * v + (b1_ * along) * phi_ + c1 * phi_.cross(v);
        Mat3 result =
            gradient_factor * phi_.transpose() + (b_ * phi_) * v.transpose() - cross_matrix<Real>(c * v);
        result.diagonal().array() += b_ * along;
        return result;
    }

    Vec3 phi_;
    Real a_, b_, c_, a1_, b1_, c1_;
};

// T(φ)⁻¹ and derivatives of it, of rotations of less than 1 rad.
template <class Real>
class SmallInverseRotation {
  public:
    using Vec3 = Eigen::Matrix<Real, 3, 1>;
    using Mat3 = Eigen::Matrix<Real, 3, 3>;

    explicit SmallInverseRotation(const Vec3& phi)
        : phi_(phi),
          d_(evaluate_series(series, Real(phi.squaredNorm()))),
          d1_(evaluate_series(slope_series, Real(phi.squaredNorm()))) {}

    // I − ½ [φ]× + d [φ]×².
    Mat3 tangent_map_inverse() const {
        Mat3 result = (d_ * phi_) * phi_.transpose() - cross_matrix<Real>(Real(0.5) * phi_);
        result.diagonal().array() += Real(1.0) - d_ * phi_.squaredNorm();
        return result;
    }
    // Of T(φ)⁻ᵀ v by φ at fixed v.
    Mat3 tangent_map_inverse_transpose_derivative(const Vec3& v) const {
        const Vec3 gradient_factor = d1_ * phi_.cross(phi_.cross(v)) - (Real(2.0) * d_) * v;
        Mat3 result = gradient_factor * phi_.transpose() + (d_ * phi_) * v.transpose() -
                      cross_matrix<Real>(Real(0.5) * v);
        result.diagonal().array() += d_ * phi_.dot(v);
        return result;
    }

  private:
    // d = Σ 2 ζ(2j + 2) (x/4π²)^j/4π²; truncated below 1e-17 for x ≤ 1.
    static constexpr std::array<double, 11> series = [] {
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
    }();
    static constexpr std::array<double, 10> slope_series = [] {
        std::array<double, 10> factors{};
        for (std::size_t j = 0; j < factors.size(); ++j)
            factors[j] = 2.0 * static_cast<double>(j + 1) * series[j + 1];
        return factors;
    }();

    Vec3 phi_;
    Real d_, d1_;
};

}  // namespace gxrod
