#include "numerics/kronrod_rule.hpp"

#include <cmath>

#include "tools/catch.hpp"

namespace gxrod {

namespace {

// ∫ ξ^power dξ over [−1, 1] by Kronrod's rule and by Gauss' one within it.
std::pair<double, double> integrate(std::size_t gauss_points, int power) {
    double kronrod = 0.0;
    double gauss = 0.0;
    for (const KronrodPoint& point : find_kronrod_rule(gauss_points)) {
        const double both = std::pow(point.xi, power) + (point.xi != 0.0 ? std::pow(-point.xi, power) : 0.0);
        kronrod += point.weight * both;
        gauss += point.gauss_weight * both;
    }
    return {kronrod, gauss};
}

}  // namespace

TEST_CASE("Rules of Kronrod and Gauss are exact for polynomials of their degrees", "[numerics]") {
    for (const std::size_t n : {2UL, 3UL, 4UL, 5UL, 7UL}) {
        for (int power = 0; power <= 3 * static_cast<int>(n) + 1; ++power) {
            INFO(n << " points of Gauss, power " << power);
            const double exact = power % 2 == 0 ? 2.0 / (power + 1) : 0.0;
            const auto [kronrod, gauss] = integrate(n, power);
            CHECK(std::abs(kronrod - exact) < 4e-16);
            if (power < 2 * static_cast<int>(n)) CHECK(std::abs(gauss - exact) < 4e-16);
        }
        // And no further.
        const auto [kronrod, gauss] = integrate(n, 2 * static_cast<int>(n));
        CHECK(std::abs(gauss - 2.0 / (2.0 * static_cast<double>(n) + 1.0)) > 1e-4);
        CHECK(kronrod > 0.0);
    }
}

}  // namespace gxrod
