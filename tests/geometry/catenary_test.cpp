#include "geometry/catenary.hpp"

#include "tools/catch.hpp"

namespace gxrod::test {

TEST_CASE("Steep and nearly straight catenaries keep their digits", "[geometry]") {
    // x = a (arsinh q − arsinh p), z = a (√(1 + q²) − √(1 + p²)) by mpmath with 60 digits.
    struct Case {
        Catenary catenary;
        double s, x, z;
    };
    for (const Case& known : {Case{{1000.0, 3.0}, 5.0, 0.00496286838639774561, 4.99999753694763293},
                              Case{{-2e5, 1e-3}, 40.0, 0.000200000019997502666, -39.9999999994999999},
                              Case{{30.0, 1e-12}, 7.0, 0.23320381162844217, 6.99611434885408131},
                              Case{{0.75, 0.0}, 5.0, 4.0, 3.0}}) {
        INFO(known.catenary.slope);
        const Catenary::Point point = known.catenary.point_at(known.s);
        CHECK(point.x == Approx(known.x).epsilon(1e-15));
        CHECK(point.z == Approx(known.z).epsilon(1e-15));
        CHECK(known.catenary.slope_at(known.s) == known.catenary.slope + known.catenary.rate * known.s);
    }
}

TEST_CASE("The argument of a catenary's span solves its equation", "[geometry]") {
    for (const double x : {1e-8, 1e-3, 0.1, 1.0, 1.999, 2.001, 5.0, 30.0}) {
        INFO(x);
        // ln(sinh x / x) in extended precision; of small x by its series.
        const long double y = x;
        const long double log_ratio =
            x < 1e-2 ? y * y / 6.0L - y * y * y * y / 180.0L : std::log(std::sinh(y) / y);
        CHECK(find_catenary_argument(static_cast<double>(log_ratio)) == Approx(x).epsilon(1e-15));
    }
}

}  // namespace gxrod::test
