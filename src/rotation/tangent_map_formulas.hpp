#pragma once

#include <Eigen/Geometry>

#include "rotation/cross_products.hpp"

// T(φ), its inverse and their derivatives from given coefficients (coefficients.hpp). Real is double, or
// several of them that are worked on at once.
namespace gxrod::formulas {

template <class Real>
using Vector3 = Eigen::Matrix<Real, 3, 1>;
template <class Real>
using Matrix3 = Eigen::Matrix<Real, 3, 3>;

// f I + g [φ]× + h φ ⊗ φ.
template <class Real>
Matrix3<Real> compose(const Vector3<Real>& phi, const Real& f, const Real& g, const Real& h) {
    Matrix3<Real> result = (h * phi) * phi.transpose() + cross_matrix<Real>(g * phi);
    result.diagonal().array() += f;
    return result;
}

// I − ½ [φ]× + d [φ]×².
template <class Real>
Matrix3<Real> invert(const Vector3<Real>& phi, const Real& d) {
    return compose<Real>(phi, Real(1.0) - d * phi.squaredNorm(), Real(-0.5), d);
}

// The gradients of a, b and c are a₁ φ, b₁ φ and c₁ φ.
template <class Real>
struct Slopes {
    Real a1, b, b1, c, c1;
};

// Derivative of a v + b (φ·v) φ + c φ × v by φ.
template <class Real>
Matrix3<Real> derive(const Vector3<Real>& phi, const Vector3<Real>& v, const Slopes<Real>& slopes) {
    const Real along = phi.dot(v);
    const Vector3<Real> gradient_factor =
        slopes.a1 * v + (slopes.b1 * along) * phi + slopes.c1 * phi.cross(v);
    Matrix3<Real> result = gradient_factor * phi.transpose() + (slopes.b * phi) * v.transpose() -
                           cross_matrix<Real>(slopes.c * v);
    result.diagonal().array() += slopes.b * along;
    return result;
}

// Derivative of v − sign ½ φ × v + d φ × (φ × v) by φ; the gradient of d is d₁ φ.
template <class Real>
Matrix3<Real> derive_inverse(
    const Vector3<Real>& phi, const Vector3<Real>& v, const Real& sign, const Real& d, const Real& d1) {
    const Vector3<Real> gradient_factor = d1 * phi.cross(phi.cross(v)) - (Real(2.0) * d) * v;
    Matrix3<Real> result = gradient_factor * phi.transpose() + (d * phi) * v.transpose() +
                           cross_matrix<Real>((Real(0.5) * sign) * v);
    result.diagonal().array() += d * phi.dot(v);
    return result;
}

// The gradients of the slopes are a₂ φ, b₂ φ and c₂ φ.
template <class Real>
struct Curvatures {
    Real a2, b2, c2;
};

// The second derivative by φ of u · T(φ) v, the scalar a (u·v) + b (φ·u)(φ·v) + c φ·w with w = v × u.
template <class Real>
Matrix3<Real> derive_twice(const Vector3<Real>& phi,
                           const Vector3<Real>& u,
                           const Vector3<Real>& v,
                           const Slopes<Real>& slopes,
                           const Curvatures<Real>& curvatures) {
    const Vector3<Real> w = v.cross(u);
    const Real s = u.dot(v);
    const Real p = phi.dot(u);
    const Real q = phi.dot(v);
    const Real r = phi.dot(w);
    const Real second = curvatures.a2 * s + curvatures.b2 * p * q + curvatures.c2 * r;
    const Real first = slopes.a1 * s + slopes.b1 * p * q + slopes.c1 * r;
    const Vector3<Real> g = slopes.b1 * (q * u + p * v) + slopes.c1 * w + (Real(0.5) * second) * phi;
    Matrix3<Real> half = phi * g.transpose() + (slopes.b * u) * v.transpose();
    half.diagonal().array() += Real(0.5) * first;
    return half + half.transpose();
}

}  // namespace gxrod::formulas
