#include "deck/section_shape.hpp"

#include <algorithm>
#include <cmath>

namespace gxrod {
namespace {

// J of a rectangle with the sides a ≥ b, Timoshenko and Goodier, "Theory of Elasticity", art. 109:
// J = a b³ (1/3 − (64/π⁵)(b/a) Σ tanh(n π a/(2b))/n⁵), n odd. With tanh x = 1 − 2/(exp(2x) + 1) and
// Σ 1/n⁵ = (31/32) ζ(5) what is left to sum falls like exp(−n π a/b).
double compute_rectangle_torsion(double a, double b) {
    constexpr double zeta_5 = 1.0369277551433699263;
    double sum = 31.0 / 32.0 * zeta_5;
    for (int n = 1; n <= 11; n += 2) {
        sum -= 2.0 / (std::pow(n, 5) * (std::exp(n * M_PI * a / b) + 1.0));
    }
    return a * b * b * b * (1.0 / 3.0 - 64.0 / std::pow(M_PI, 5) * (b / a) * sum);
}

}  // namespace

ShapeConstants compute_circle(double radius, double nu) { return compute_tube(radius, 0.0, nu); }

ShapeConstants compute_tube(double outer, double inner, double nu) {
    ShapeConstants shape;
    const double difference = (outer - inner) * (outer + inner);
    const double sum = outer * outer + inner * inner;
    shape.area = M_PI * difference;
    shape.second_moment_y = shape.second_moment_z = M_PI / 4.0 * difference * sum;
    shape.torsion_constant = M_PI / 2.0 * difference * sum;
    const double m = inner / outer;
    const double whole = (1.0 + m * m) * (1.0 + m * m);
    shape.shear_factor = 6.0 * (1.0 + nu) * whole / ((7.0 + 6.0 * nu) * whole + (20.0 + 12.0 * nu) * m * m);
    return shape;
}

ShapeConstants compute_rectangle(double width, double height, double nu) {
    ShapeConstants shape;
    shape.area = width * height;
    shape.second_moment_y = width * height * height * height / 12.0;
    shape.second_moment_z = height * width * width * width / 12.0;
    shape.torsion_constant = compute_rectangle_torsion(std::max(width, height), std::min(width, height));
    shape.shear_factor = 10.0 * (1.0 + nu) / (12.0 + 11.0 * nu);
    return shape;
}

}  // namespace gxrod
