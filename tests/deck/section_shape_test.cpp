#include "deck/section_shape.hpp"

#include <catch2/catch.hpp>
#include <cmath>

namespace gxrod::test {
namespace {

// J of a rectangle by the series as it stands in books, summed until it no longer changes:
// J = a b³ (1/3 − (64/π⁵)(b/a) Σ tanh(n π a/(2b))/n⁵), n odd, a ≥ b.
double compute_torsion_by_long_series(double a, double b) {
    double sum = 0.0;
    for (int n = 20001; n >= 1; n -= 2) sum += std::tanh(n * M_PI * a / (2.0 * b)) / std::pow(n, 5);
    return a * b * b * b * (1.0 / 3.0 - 64.0 / std::pow(M_PI, 5) * (b / a) * sum);
}

}  // namespace

TEST_CASE("The constants of a circle are those of books", "[deck]") {
    const ShapeConstants circle = compute_circle(0.2, 0.3);
    CHECK(circle.area == Approx(M_PI * 0.04).epsilon(1e-15));
    CHECK(circle.second_moment_y == Approx(M_PI * 0.0016 / 4.0).epsilon(1e-15));
    CHECK(circle.second_moment_z == circle.second_moment_y);
    CHECK(circle.torsion_constant == Approx(M_PI * 0.0016 / 2.0).epsilon(1e-15));
    CHECK(circle.shear_factor == Approx(6.0 * 1.3 / (7.0 + 1.8)).epsilon(1e-15));
}

TEST_CASE("A tube is a circle less its hole, down to a thin wall", "[deck]") {
    const ShapeConstants tube = compute_tube(3.0, 2.0, 0.25);
    CHECK(tube.area == Approx(M_PI * 5.0).epsilon(1e-15));
    CHECK(tube.second_moment_y == Approx(M_PI * 65.0 / 4.0).epsilon(1e-15));
    CHECK(tube.torsion_constant == Approx(M_PI * 65.0 / 2.0).epsilon(1e-15));
    const double wall = 1e-9;
    const ShapeConstants thin = compute_tube(1.0, 1.0 - wall, 0.3);
    CHECK(thin.second_moment_y == Approx(M_PI * wall).epsilon(1e-7));
    // Cowper (1966): a thin tube has 2(1 + ν)/(4 + 3ν).
    CHECK(thin.shear_factor == Approx(2.0 * 1.3 / 4.9).epsilon(1e-8));
    CHECK(compute_tube(1.0, 1e-9, 0.3).shear_factor == Approx(compute_circle(1.0, 0.3).shear_factor));
}

TEST_CASE("The constants of a rectangle are those of books, y and z in their places", "[deck]") {
    const ShapeConstants rectangle = compute_rectangle(0.05, 0.1, 0.3);
    CHECK(rectangle.area == Approx(0.005).epsilon(1e-15));
    CHECK(rectangle.second_moment_y == Approx(0.05 * 1e-3 / 12.0).epsilon(1e-15));
    CHECK(rectangle.second_moment_z == Approx(0.1 * 1.25e-4 / 12.0).epsilon(1e-15));
    CHECK(rectangle.shear_factor == Approx(13.0 / 15.3).epsilon(1e-15));
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
