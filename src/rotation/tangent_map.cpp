#include "rotation/tangent_map.hpp"

#include "rotation/coefficients.hpp"
#include "rotation/rotation_map.hpp"

// Transposes come by a change of sign: T(φ)ᵀ = T(−φ) differs from T(φ) in the sign of its skew term alone.
// The gradient of a coefficient is ∇a = a1 φ.
namespace gxrod {
namespace {

// Derivative of a v + b (φ·v) φ + sign c φ × v.
Mat3 compute_derivative(const Vec3& phi, const Vec3& v, double sign) {
    const double angle = phi.norm();
    const double c = sign * coefficients::c(angle);
    const double c1 = sign * coefficients::c1(angle);
    const double along = phi.dot(v);
    const Vec3 gradient_factor =
        coefficients::a1(angle) * v + coefficients::b1(angle) * along * phi + c1 * phi.cross(v);
    const double b = coefficients::b(angle);
    Mat3 result = gradient_factor * phi.transpose() + (b * phi) * v.transpose() - spin(c * v);
    result.diagonal().array() += b * along;
    return result;
}

// Derivative of v − sign ½ φ × v + d φ × (φ × v).
Mat3 compute_inverse_derivative(const Vec3& phi, const Vec3& v, double sign) {
    const double angle = phi.norm();
    const double along = phi.dot(v);
    const double d = coefficients::d(angle);
    const Vec3 gradient_factor = coefficients::d1(angle) * phi.cross(phi.cross(v)) - (2.0 * d) * v;
    Mat3 result = gradient_factor * phi.transpose() + (d * phi) * v.transpose() + spin((0.5 * sign) * v);
    result.diagonal().array() += d * along;
    return result;
}

}  // namespace

Mat3 tangent_map(const Vec3& phi) {
    const double angle = phi.norm();
    Mat3 result = (coefficients::b(angle) * phi) * phi.transpose() + spin(coefficients::c(angle) * phi);
    result.diagonal().array() += coefficients::a(angle);
    return result;
}

Mat3 tangent_map_inverse(const Vec3& phi) {
    const double d = coefficients::d(phi.norm());
    Mat3 result = (d * phi) * phi.transpose() - spin(0.5 * phi);
    result.diagonal().array() += 1.0 - d * phi.squaredNorm();
    return result;
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

// The scalar is a (u·v) + b (φ·u)(φ·v) + c φ·w with w = v × u.
Mat3 tangent_map_hessian(const Vec3& phi, const Vec3& u, const Vec3& v) {
    namespace k = coefficients;
    const double angle = phi.norm();
    const double b = k::b(angle);
    const double b1 = k::b1(angle);
    const double c1 = k::c1(angle);
    const Vec3 w = v.cross(u);
    const double s = u.dot(v);
    const double p = phi.dot(u);
    const double q = phi.dot(v);
    const double r = phi.dot(w);
    const double second = k::a2(angle) * s + k::b2(angle) * p * q + k::c2(angle) * r;
    const double first = k::a1(angle) * s + b1 * p * q + c1 * r;
    const Vec3 g = b1 * (q * u + p * v) + c1 * w + (0.5 * second) * phi;
    Mat3 half = phi * g.transpose() + (b * u) * v.transpose();
    half.diagonal().array() += 0.5 * first;
    return half + half.transpose();
}

}  // namespace gxrod
