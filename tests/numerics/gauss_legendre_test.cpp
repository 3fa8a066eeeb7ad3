#include "numerics/gauss_legendre.hpp"

#include <cmath>

#include "tools/catch.hpp"

using namespace gxrod;

namespace {

template <int Points>
void check_gauss_rule() {
    INFO(Points << " points");
    for (int power = 0; power <= 2 * Points; ++power) {
        double integral = 0.0;
        for (const auto& [xi, weight] : compute_gauss_rule<Points>())
            integral += weight * std::pow(xi, power);
        const double exact = power % 2 == 0 ? 2.0 / (power + 1) : 0.0;
        const double error = std::abs(integral - exact);
        if (power < 2 * Points) {
            CHECK(error < 1e-15);
        } else {
            CHECK(error > 5e-4);  // one degree more is beyond the rule
        }
    }
    const auto rule = compute_gauss_rule<Points>();
    for (int i = 1; i < Points; ++i) CHECK(rule[i].xi > rule[i - 1].xi);
}

}  // namespace

TEST_CASE("Gauss rules integrate polynomials exactly", "[numerics]") {
    check_gauss_rule<1>();
    check_gauss_rule<2>();
    check_gauss_rule<3>();
    check_gauss_rule<4>();
    check_gauss_rule<5>();
    check_gauss_rule<6>();
}

TEST_CASE("The Gauss rule of twelve points is exact to degree 23", "[numerics]") {
    const auto integrate = [](int degree) {
        double sum = 0.0;
        for (const auto& [xi, weight] : compute_gauss_rule<12>())
            sum += 0.5 * weight * std::pow(0.5 * (1.0 + xi), degree);
        return sum;
    };
    for (int degree = 0; degree <= 23; ++degree) {
        INFO(degree);
        CHECK(std::abs(integrate(degree) * (degree + 1) - 1.0) < 1e-14);
    }
    CHECK(std::abs(integrate(24) * 25 - 1.0) > 1e-14);
}
