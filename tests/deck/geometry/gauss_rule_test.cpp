#include "deck/geometry/gauss_rule.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace gxrod;

TEST_CASE("The Gauss rule is exact for polynomials up to degree 23", "[deck]") {
    const auto integrate = [](int degree) {
        double sum = 0.0;
        for (const GaussPoint& point : gauss_rule()) sum += point.weight * std::pow(point.at, degree);
        return sum;
    };
    for (int degree = 0; degree <= 23; ++degree) {
        INFO(degree);
        CHECK(std::abs(integrate(degree) * (degree + 1) - 1.0) < 1e-14);
    }
    CHECK(std::abs(integrate(24) * 25 - 1.0) > 1e-14);
}
