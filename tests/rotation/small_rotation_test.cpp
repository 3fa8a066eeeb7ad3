#include "rotation/small_rotation.hpp"

#include "rotation/rotation_map.hpp"
#include "rotation/tangent_map.hpp"
#include "tools/catch.hpp"
#include "tools/random_values.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

void check(const Mat3& value, const Mat3& expected) {
    CHECK((value - expected).lpNorm<Eigen::Infinity>() <=
          2e-15 * std::max(1.0, expected.lpNorm<Eigen::Infinity>()));
}

}  // namespace

TEST_CASE("Series of small rotations agree with the coefficients for any", "[rotation]") {
    RandomValues random(3);
    for (const double angle : {0.0, 1e-9, 1e-3, 0.1, 0.3, 0.6, 0.9, 1.0}) {
        CAPTURE(angle);
        const Vec3 phi = angle * random.direction();
        const Vec3 u = random.vector();
        const Vec3 v = random.vector();
        const SmallRotation<double> rotation(phi);
        check(rotation.exp(), exp_matrix(phi));
        check(rotation.tangent_map(), tangent_map(phi));
        check(rotation.tangent_map_derivative(v), tangent_map_derivative(phi, v));
        check(rotation.tangent_map_transpose_derivative(v), tangent_map_transpose_derivative(phi, v));
        check(rotation.tangent_map_hessian(u, v), tangent_map_hessian(phi, u, v));
        // The derivative of T(φ) w along u, for three w.
        Mat3 slope;
        for (int k = 0; k < 3; ++k) slope.col(k) = tangent_map_derivative(phi, Vec3::Unit(k)) * u;
        check(rotation.tangent_map_slope(u), slope);
        // The second derivative of each entry along u and v, and what w adds as the rate of u.
        const Vec3 w = random.vector();
        Mat3 slope_rate;
        for (int i = 0; i < 3; ++i) {
            for (int k = 0; k < 3; ++k) {
                slope_rate(i, k) = u.dot(tangent_map_hessian(phi, Vec3::Unit(i), Vec3::Unit(k)) * v) +
                                   tangent_map_derivative(phi, Vec3::Unit(k)).row(i).dot(w);
            }
        }
        check(rotation.tangent_map_slope_rate(u, v, w), slope_rate);
        const SmallInverseRotation<double> inverse(phi);
        check(inverse.tangent_map_inverse(), tangent_map_inverse(phi));
        Mat3 rate;
        for (int k = 0; k < 3; ++k) rate.col(k) = tangent_map_inverse_derivative(phi, Vec3::Unit(k)) * u;
        check(inverse.tangent_map_inverse_rate(u), rate);
        check(inverse.tangent_map_inverse_transpose_derivative(v),
              tangent_map_inverse_transpose_derivative(phi, v));
    }
}
