#include "rotation/tangent_map.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "rotation/rotation_map.hpp"
#include "rotation/samples.hpp"
#include "tools/catch.hpp"

using namespace gxrod;

namespace {

using std::numbers::pi;
constexpr double step = 0.004;

// Calls check(φ, u, v) with random directions at every special angle and with random angles past half a turn.
template <typename Check>
void for_random_vectors(unsigned seed, Check check) {
    samples::Random random(seed);
    const auto call = [&](double angle) {
        const Vec3 phi = angle * random.direction();
        const Vec3 u = random.vector();
        const Vec3 v = random.vector();
        INFO("angle " << angle << ", phi " << phi.transpose());
        check(phi, u, v);
    };
    for (const double angle : samples::angles_past_pi())
        for (int i = 0; i < 10; ++i) call(angle);
    for (int i = 0; i < 300; ++i) call(random.between(0.0, 5.2));
}

// T⁻¹ grows towards its pole at 2π, and its differences lose accuracy with it.
double error_of(const Mat3& result, const Mat3& expected) {
    return (result - expected).norm() / std::max(1.0, expected.norm());
}

}  // namespace

TEST_CASE("T takes the rate of the rotation vector to the spin of exp", "[rotation][tangent_map]") {
    for_random_vectors(21, [](const Vec3& phi, const Vec3&, const Vec3& v) {
        const Mat3 rate =
            samples::central_difference([&](double t) -> Mat3 { return exp_matrix(phi + t * v); }, step);
        const Mat3 spin_of_exp = rate * exp_matrix(phi).transpose();
        CHECK((spin_of_exp - spin(tangent_map(phi) * v)).norm() <= 1e-11);
    });
}

TEST_CASE("T is (3.6a) about a known axis", "[rotation][tangent_map]") {
    // About e3: the part along the axis passes, the part across is turned by half the angle and shortened.
    for (const double angle : {0.3, 1.7, pi, 4.4}) {
        const Mat3 T = tangent_map(angle * Vec3::UnitZ());
        const double shortened = std::sin(0.5 * angle) / (0.5 * angle);
        const Vec3 turned(shortened * std::cos(0.5 * angle), shortened * std::sin(0.5 * angle), 0.0);
        CHECK((T.col(2) - Vec3::UnitZ()).norm() <= 1e-15);
        CHECK((T.col(0) - turned).norm() <= 1e-15);
    }
    CHECK(tangent_map(Vec3::Zero()) == Mat3::Identity());
    CHECK(tangent_map_inverse(Vec3::Zero()) == Mat3::Identity());
}

TEST_CASE("T and its inverse multiply to one", "[rotation][tangent_map]") {
    for_random_vectors(22, [](const Vec3& phi, const Vec3&, const Vec3&) {
        CHECK((tangent_map(phi) * tangent_map_inverse(phi) - Mat3::Identity()).norm() <= 1e-14);
        CHECK((tangent_map_inverse(phi) * tangent_map(phi) - Mat3::Identity()).norm() <= 1e-14);
    });
}

TEST_CASE("T transposes by the sign of its vector and by exp", "[rotation][tangent_map]") {
    for_random_vectors(23, [](const Vec3& phi, const Vec3&, const Vec3&) {
        const Mat3 T = tangent_map(phi);
        CHECK((T.transpose() - tangent_map(-phi)).norm() <= 1e-15);
        CHECK((exp_matrix(phi).transpose() * T - T.transpose()).norm() <= 1e-14);
        CHECK((tangent_map_inverse(phi).transpose() - tangent_map_inverse(-phi)).norm() <= 1e-15);
    });
}

TEST_CASE("derivative of T v", "[rotation][tangent_map]") {
    for_random_vectors(24, [](const Vec3& phi, const Vec3&, const Vec3& v) {
        const Mat3 expected = samples::difference_jacobian(
            [&](const Vec3& x) -> Vec3 { return tangent_map(x) * v; }, phi, step);
        CHECK(error_of(tangent_map_derivative(phi, v), expected) <= 1e-11);
    });
}

TEST_CASE("derivative of T transposed v", "[rotation][tangent_map]") {
    for_random_vectors(25, [](const Vec3& phi, const Vec3&, const Vec3& v) {
        const Mat3 expected = samples::difference_jacobian(
            [&](const Vec3& x) -> Vec3 { return tangent_map(x).transpose() * v; }, phi, step);
        CHECK(error_of(tangent_map_transpose_derivative(phi, v), expected) <= 1e-11);
    });
}

TEST_CASE("derivative of the inverse of T, times v", "[rotation][tangent_map]") {
    for_random_vectors(26, [](const Vec3& phi, const Vec3&, const Vec3& v) {
        const Mat3 expected = samples::difference_jacobian(
            [&](const Vec3& x) -> Vec3 { return tangent_map_inverse(x) * v; }, phi, step);
        CHECK(error_of(tangent_map_inverse_derivative(phi, v), expected) <= 1e-11);
    });
}

TEST_CASE("derivative of the inverse of T, transposed, times v", "[rotation][tangent_map]") {
    for_random_vectors(27, [](const Vec3& phi, const Vec3&, const Vec3& v) {
        const Mat3 expected = samples::difference_jacobian(
            [&](const Vec3& x) -> Vec3 { return tangent_map_inverse(x).transpose() * v; }, phi, step);
        CHECK(error_of(tangent_map_inverse_transpose_derivative(phi, v), expected) <= 1e-11);
    });
}

TEST_CASE("the derivatives of T and of its inverse agree exactly", "[rotation][tangent_map]") {
    // δ(T⁻¹ v) = −T⁻¹ δT T⁻¹ v.
    for_random_vectors(28, [](const Vec3& phi, const Vec3&, const Vec3& v) {
        const Mat3 inverse = tangent_map_inverse(phi);
        const Mat3 expected = -inverse * tangent_map_derivative(phi, inverse * v);
        CHECK(error_of(tangent_map_inverse_derivative(phi, v), expected) <= 1e-14);
    });
}

TEST_CASE("Hessian of u T v", "[rotation][tangent_map]") {
    for_random_vectors(29, [](const Vec3& phi, const Vec3& u, const Vec3& v) {
        const auto gradient = [&](const Vec3& x) -> Vec3 {
            return tangent_map_derivative(x, v).transpose() * u;
        };
        const Mat3 hessian = tangent_map_hessian(phi, u, v);
        CHECK(error_of(hessian, samples::difference_jacobian(gradient, phi, step)) <= 1e-11);
        CHECK(hessian == hessian.transpose());
    });
}
