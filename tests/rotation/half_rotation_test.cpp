#include "rotation/half_rotation.hpp"

#include "tools/catch.hpp"
#include "tools/random_values.hpp"

using namespace gxrod;
using namespace gxrod::tools;

namespace {

struct Coefficients {
    long double x, y, t;
};

Coefficients compute_closed_forms(long double theta) {
    const long double x = 0.5L * theta / std::sin(0.5L * theta);
    return {x, (1.0L - x) / (theta * theta), std::tan(0.25L * theta) / theta};
}

// d/dθ over θ by central differences.
Coefficients compute_slopes(long double theta) {
    constexpr long double step = 1e-5L;
    const Coefficients more = compute_closed_forms(theta + step);
    const Coefficients less = compute_closed_forms(theta - step);
    const long double scale = 1.0L / (2.0L * step * theta);
    return {scale * (more.x - less.x), scale * (more.y - less.y), scale * (more.t - less.t)};
}

}  // namespace

TEST_CASE("Halves of a rotation follow their closed forms at every angle", "[rotation]") {
    RandomValues random(1);
    for (const double theta : {0.05, 0.2, 0.5, 0.505, 0.506, 0.51, 0.6, 1.0, 2.0, 3.0, 3.14}) {
        CAPTURE(theta);
        const Vec3 Phi = theta * random.direction();
        const HalfRotation<double> rotation = split_rotation(exp_quaternion(Phi));
        CHECK((rotation.Phi - Phi).norm() < 1e-15 * (1.0 + theta) / std::cos(0.25 * theta));
        CHECK((rotation.tau - std::tan(0.25 * theta) / theta * Phi).norm() < 1e-15);
        CHECK(rotation.half.angularDistance(exp_quaternion(0.5 * Phi)) < 1e-15);
        const Coefficients exact = compute_closed_forms(theta);
        CHECK(rotation.x == Approx(static_cast<double>(exact.x)).epsilon(1e-14));
        CHECK(rotation.y == Approx(static_cast<double>(exact.y)).epsilon(1e-13));
        CHECK(rotation.t == Approx(static_cast<double>(exact.t)).epsilon(1e-14));
        const Coefficients slope = compute_slopes(theta);
        CHECK(rotation.x1 == Approx(static_cast<double>(slope.x)).epsilon(1e-9));
        CHECK(rotation.y1 == Approx(static_cast<double>(slope.y)).epsilon(1e-6));
        CHECK(rotation.t1 == Approx(static_cast<double>(slope.t)).epsilon(1e-9));
    }
}

TEST_CASE("Halves of no rotation, and of a quaternion of either sign", "[rotation]") {
    for (const double theta : {0.0, 1e-200, 1e-9}) {
        const HalfRotation<double> rotation = split_rotation(exp_quaternion(Vec3(0.0, theta, 0.0)));
        CHECK(rotation.Phi == Vec3(0.0, theta, 0.0));
        CHECK(rotation.x == 1.0);
        CHECK(rotation.y == Approx(-1.0 / 24.0).epsilon(1e-15));
        CHECK(rotation.t == 0.25);
        CHECK(rotation.x1 == Approx(1.0 / 12.0).epsilon(1e-15));
        CHECK(rotation.y1 == Approx(-7.0 / 2880.0).epsilon(1e-15));
        CHECK(rotation.t1 == Approx(1.0 / 96.0).epsilon(1e-15));
    }
    const Quat q = exp_quaternion(Vec3(0.1, -0.7, 0.4));
    const HalfRotation<double> plus = split_rotation(q);
    const HalfRotation<double> minus = split_rotation(Quat(-q.coeffs()));
    CHECK(plus.Phi == minus.Phi);
    CHECK(plus.half.coeffs() == minus.half.coeffs());
}
