#include "rotation/tangent_map.hpp"

#include <cmath>

#include "rotation/coefficients.hpp"
#include "rotation/small_rotation.hpp"
#include "rotation/tangent_map_formulas.hpp"

// Transposes come by a change of sign: T(φ)ᵀ = T(−φ) differs from T(φ) in the sign of its skew term alone.
// The gradient of a coefficient is ∇a = a1 φ.
namespace gxrod {
namespace {

// Of T(φ), or with sign = −1 of T(φ)ᵀ.
formulas::Slopes<double> compute_slopes(double angle, double sign) {
    return {.a1 = coefficients::a1(angle),
            .b = coefficients::b(angle),
            .b1 = coefficients::b1(angle),
            .c = sign * coefficients::c(angle),
            .c1 = sign * coefficients::c1(angle)};
}

Mat3 compute_derivative(const Vec3& phi, const Vec3& v, double sign) {
    return formulas::derive<double>(phi, v, compute_slopes(phi.norm(), sign));
}

Mat3 compute_inverse_derivative(const Vec3& phi, const Vec3& v, double sign) {
    const double angle = phi.norm();
    return formulas::derive_inverse<double>(phi, v, sign, coefficients::d(angle), coefficients::d1(angle));
}

}  // namespace

Mat3 tangent_map(const Vec3& phi) {
    const double angle = phi.norm();
    return formulas::compose<double>(
        phi, coefficients::a(angle), coefficients::c(angle), coefficients::b(angle));
}

Mat3 tangent_map_inverse(const Vec3& phi) {
    const double square = phi.squaredNorm();
    if (square < 1.0) return SmallInverseRotation<double>(phi).tangent_map_inverse();
    return formulas::invert<double>(phi, coefficients::d(std::sqrt(square)));
}

Mat3 tangent_map_derivative(const Vec3& phi, const Vec3& v) { return compute_derivative(phi, v, 1.0); }

Mat3 tangent_map_transpose_derivative(const Vec3& phi, const Vec3& v) {
    return compute_derivative(phi, v, -1.0);
}

Mat3 tangent_map_inverse_derivative(const Vec3& phi, const Vec3& v) {
    return compute_inverse_derivative(phi, v, 1.0);
}

Mat3 tangent_map_inverse_transpose_derivative(const Vec3& phi, const Vec3& v) {
    return compute_inverse_derivative(phi, v, -1.0);
}

Mat3 tangent_map_hessian(const Vec3& phi, const Vec3& u, const Vec3& v) {
    const double angle = phi.norm();
    return formulas::derive_twice<double>(
        phi,
        u,
        v,
        compute_slopes(angle, 1.0),
        {coefficients::a2(angle), coefficients::b2(angle), coefficients::c2(angle)});
}

}  // namespace gxrod
