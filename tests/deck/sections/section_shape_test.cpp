#include "deck/sections/section_shape.hpp"

#include <cmath>

#include "deck/cross_section.hpp"
#include "tools/catch.hpp"

namespace gxrod::test {
namespace {

// J of a rectangle by the series as in textbooks, summed until it no longer changes:
// J = a b³ (1/3 − (64/π⁵)(b/a) Σ tanh(n π a/(2b))/n⁵), n odd, a ≥ b.
double compute_torsion_by_long_series(double a, double b) {
    double sum = 0.0;
    for (int n = 20001; n >= 1; n -= 2) sum += std::tanh(n * M_PI * a / (2.0 * b)) / std::pow(n, 5);
    return a * b * b * b * (1.0 / 3.0 - 64.0 / std::pow(M_PI, 5) * (b / a) * sum);
}

SectionMap tube_map(double outer, double inner) {
    return [=](double u, double v) -> Eigen::Vector2d {
        const double r = inner + u * (outer - inner);
        return {r * std::cos(2.0 * M_PI * v), r * std::sin(2.0 * M_PI * v)};
    };
}

SectionMap rectangle_map(double width, double height) {
    return [=](double u, double v) -> Eigen::Vector2d { return {width * (u - 0.5), height * (v - 0.5)}; };
}

// k along y and z from a compliance, with E = 1.
Eigen::Vector2d find_factors(const Mat6& compliance, double area, double nu) {
    const double GA = area / (2.0 * (1.0 + nu));
    return {1.0 / (compliance(1, 1) * GA), 1.0 / (compliance(2, 2) * GA)};
}

// Of a rectangle by Saint-Venant's series in sines, term by term, summed until it no longer changes.
double compute_factor_by_long_series(double along, double across, double nu) {
    const double rho = across / along;
    double sum = 0.0;
    for (int m = 100000; m >= 1; --m) {
        const double x = m * M_PI / rho;
        sum += (1.0 - std::tanh(x) / x) / std::pow(m, 4);
    }
    const double n = nu / (1.0 + nu);
    return 1.0 / (1.2 + n * n * 18.0 * std::pow(rho / M_PI, 4) * sum);
}

}  // namespace

TEST_CASE("The section analysis of the tests knows what is exact", "[deck]") {
    const Mat6 compliance = compute_section_compliance({rectangle_map(2.0, 1.0), 8, 8, false, 1.0, 0.3});
    CHECK(1.0 / compliance(0, 0) == Approx(2.0).epsilon(1e-12));
    CHECK(1.0 / compliance(4, 4) == Approx(2.0 / 12.0).epsilon(1e-12));
    CHECK(1.0 / compliance(5, 5) == Approx(8.0 / 12.0).epsilon(1e-12));
    const double J = compute_rectangle(2.0, 1.0, 0.3).torsion_constant;
    CHECK(1.0 / compliance(3, 3) == Approx(J / 2.6).epsilon(1e-3));
    CHECK(std::abs(compliance(1, 5)) < 1e-12);
}

TEST_CASE("Shear factors of circles and tubes store the energy of the exact flexure", "[deck]") {
    for (const double nu : {-0.5, 0.3}) {
        for (const double inner : {0.0, 0.3, 0.9}) {
            const ShapeConstants tube = compute_tube(1.0, inner, nu);
            const Mat6 compliance = compute_section_compliance({tube_map(1.0, inner), 8, 32, true, 1.0, nu});
            const Eigen::Vector2d factors = find_factors(compliance, tube.area, nu);
            INFO("nu " << nu << ", inner radius " << inner);
            CHECK(tube.shear_factor_y == Approx(factors[0]).epsilon(2e-5));
            CHECK(tube.shear_factor_z == Approx(factors[1]).epsilon(2e-5));
        }
    }
    // What programs for the analysis of cross-sections print of two tubes, as shear stiffnesses.
    const ShapeConstants thick = compute_tube(0.3, 0.1, 0.33);
    CHECK(thick.shear_factor_y * thick.area * 73e9 / 2.66 == Approx(4.68176e9).epsilon(2e-6));
    const ShapeConstants thin = compute_tube(0.1, 0.09, 0.2);
    CHECK(thin.shear_factor_y * thin.area * 100.0 / 2.4 == Approx(0.124925).epsilon(5e-6));
}

TEST_CASE("Shear factors of rectangles store the energy of the exact flexure", "[deck]") {
    for (const double nu : {-0.3, 0.49}) {
        for (const double height : {1.0, 0.5, 0.2}) {
            const ShapeConstants rectangle = compute_rectangle(1.0, height, nu);
            const Mat6 compliance =
                compute_section_compliance({rectangle_map(1.0, height), 40, 12, false, 1.0, nu});
            const Eigen::Vector2d factors = find_factors(compliance, rectangle.area, nu);
            INFO("nu " << nu << ", height " << height);
            CHECK(rectangle.shear_factor_y == Approx(factors[0]).epsilon(2e-5));
            CHECK(rectangle.shear_factor_z == Approx(factors[1]).epsilon(2e-5));
        }
    }
}

TEST_CASE("Both series of a rectangle's shear factor are the long one, and meet in the square", "[deck]") {
    for (const double side : {1e-2, 0.3, 0.999, 1.0, 1.001, 3.0, 40.0}) {
        const ShapeConstants rectangle = compute_rectangle(side, 1.0, 0.3);
        INFO("side " << side);
        CHECK(rectangle.shear_factor_z ==
              Approx(compute_factor_by_long_series(1.0, side, 0.3)).epsilon(1e-10));
        CHECK(rectangle.shear_factor_y ==
              Approx(compute_factor_by_long_series(side, 1.0, 0.3)).epsilon(1e-10));
    }
    CHECK(compute_rectangle(1.0 + 1e-15, 1.0, 0.3).shear_factor_y ==
          Approx(compute_rectangle(1.0, 1.0, 0.3).shear_factor_y).epsilon(1e-14));
}

TEST_CASE("Shear factors have the limits that books print", "[deck]") {
    CHECK(compute_circle(1.0, 0.0).shear_factor_y == Approx(6.0 / 7.0).epsilon(1e-15));
    // Renton (1991): 1/k = 7/6 + (ν/(1 + ν))²/6 of a circle.
    CHECK(1.0 / compute_circle(1.0, 0.5).shear_factor_y == Approx(7.0 / 6.0 + 1.0 / 54.0).epsilon(1e-15));
    CHECK(compute_rectangle(1.0, 1.0, 0.0).shear_factor_y == Approx(5.0 / 6.0).epsilon(1e-15));
    CHECK(compute_rectangle(1.0, 1e-4, 0.3).shear_factor_y == Approx(5.0 / 6.0).epsilon(1e-15));
    for (const double nu : {-0.3, 0.0, 0.5}) {
        CHECK(compute_tube(1.0, 1.0 - 1e-9, nu).shear_factor_z == Approx(0.5).epsilon(1e-8));
    }
    // The plate's energy: stress grows from the middle to the edges.
    CHECK(1.0 / compute_rectangle(1e4, 1.0, 0.25).shear_factor_z == Approx(0.04 * 1e8).epsilon(2e-4));
}

TEST_CASE("The constants of a circle are those of books", "[deck]") {
    const ShapeConstants circle = compute_circle(0.2, 0.3);
    CHECK(circle.area == Approx(M_PI * 0.04).epsilon(1e-15));
    CHECK(circle.second_moment_y == Approx(M_PI * 0.0016 / 4.0).epsilon(1e-15));
    CHECK(circle.second_moment_z == circle.second_moment_y);
    CHECK(circle.torsion_constant == Approx(M_PI * 0.0016 / 2.0).epsilon(1e-15));
}

TEST_CASE("A tube is a circle less its hole, down to a thin wall", "[deck]") {
    const ShapeConstants tube = compute_tube(3.0, 2.0, 0.25);
    CHECK(tube.area == Approx(M_PI * 5.0).epsilon(1e-15));
    CHECK(tube.second_moment_y == Approx(M_PI * 65.0 / 4.0).epsilon(1e-15));
    CHECK(tube.torsion_constant == Approx(M_PI * 65.0 / 2.0).epsilon(1e-15));
    const double wall = 1e-9;
    const ShapeConstants thin = compute_tube(1.0, 1.0 - wall, 0.3);
    CHECK(thin.second_moment_y == Approx(M_PI * wall).epsilon(1e-7));
    CHECK(compute_tube(1.0, 1e-9, 0.3).shear_factor_y == Approx(compute_circle(1.0, 0.3).shear_factor_y));
}

TEST_CASE("The constants of a rectangle are those of books, y and z in their places", "[deck]") {
    const ShapeConstants rectangle = compute_rectangle(0.05, 0.1, 0.3);
    CHECK(rectangle.area == Approx(0.005).epsilon(1e-15));
    CHECK(rectangle.second_moment_y == Approx(0.05 * 1e-3 / 12.0).epsilon(1e-15));
    CHECK(rectangle.second_moment_z == Approx(0.1 * 1.25e-4 / 12.0).epsilon(1e-15));
}

TEST_CASE("The torsion constant of a rectangle is that of the long series, whichever side is longer",
          "[deck]") {
    CHECK(compute_rectangle(1.0, 1.0, 0.0).torsion_constant == Approx(0.1405770149).margin(1e-10));
    CHECK(compute_rectangle(1.0, 1.0, 0.0).torsion_constant == Approx(0.140577014955).epsilon(3e-12));
    // Timoshenko and Goodier's table: J/(a b³) = 0.196, 0.229, 0.263, 0.281, 0.291, 0.312.
    const double sides[] = {1.5, 2.0, 3.0, 4.0, 5.0, 10.0};
    const double printed[] = {0.196, 0.229, 0.263, 0.281, 0.291, 0.312};
    for (int i = 0; i < 6; ++i) {
        const double J = compute_rectangle(sides[i], 1.0, 0.0).torsion_constant;
        CHECK(J / sides[i] == Approx(printed[i]).margin(6e-4));
        CHECK(compute_rectangle(1.0, sides[i], 0.0).torsion_constant == J);
        CHECK(J == Approx(compute_torsion_by_long_series(sides[i], 1.0)).epsilon(1e-14));
    }
    for (const double a : {1.0, 1.01, 50.0, 1e6}) {
        CHECK(compute_rectangle(a, 1.0, 0.0).torsion_constant ==
              Approx(compute_torsion_by_long_series(a, 1.0)).epsilon(1e-14));
    }
    CHECK(compute_rectangle(2e-3, 1e-3, 0.0).torsion_constant ==
          Approx(1e-12 * compute_rectangle(2.0, 1.0, 0.0).torsion_constant).epsilon(1e-14));
}

}  // namespace gxrod::test
