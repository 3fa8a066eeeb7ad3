#include "deck/sections/section_shape.hpp"

#include <algorithm>
#include <cmath>

// Shear factors: docs/theory/shear_stiffness.md, whose numbers of equations the comments give.
namespace gxrod {
namespace {

constexpr double zeta_5 = 1.0369277551433699263;  // Σ 1/m⁵
// Of series whose terms fall like exp(−m π) at least.
constexpr int series_terms = 6;

// J of a rectangle with the sides a ≥ b, Timoshenko and Goodier, "Theory of Elasticity", art. 109:
// J = a b³ (1/3 − (64/π⁵)(b/a) Σ tanh(n π a/(2b))/n⁵), n odd. With tanh x = 1 − 2/(exp(2x) + 1) and
// Σ 1/n⁵ = (31/32) ζ(5) what is left to sum falls like exp(−n π a/b).
double compute_rectangle_torsion(double a, double b) {
    double sum = 31.0 / 32.0 * zeta_5;
    for (int n = 1; n <= 11; n += 2) {
        sum -= 2.0 / (std::pow(n, 5) * (std::exp(n * M_PI * a / b) + 1.0));
    }
    return a * b * b * b * (1.0 / 3.0 - 64.0 / std::pow(M_PI, 5) * (b / a) * sum);
}

// ν/(1 + ν): how much a bending section's sideways contraction disturbs the shear stresses.
double compute_contraction(double nu) { return nu / (1.0 + nu); }

// c(ρ) of (S9) for ρ ≤ 1, sides ρ across the force and 1 along it.
double compute_narrow_term(double rho) {
    double sum = zeta_5;
    for (int m = 1; m <= series_terms; ++m) {
        sum -= 2.0 / (std::pow(m, 5) * (std::exp(2.0 * m * M_PI / rho) + 1.0));
    }
    return std::pow(rho, 4) * (0.2 - 18.0 * rho / std::pow(M_PI, 5) * sum);
}

// c(ρ) of (S10) for ρ ≥ 1.
double compute_wide_term(double rho) {
    double sum = 558.0 * zeta_5;
    for (int m = 1; m <= 2 * series_terms; m += 2) {
        sum += 1152.0 / (std::pow(m, 5) * std::expm1(m * M_PI * rho));
    }
    return rho * rho + 1.2 - rho / std::pow(M_PI, 5) * sum;
}

// `across` and `along` are the sides across the force and along it; (S8).
double compute_rectangle_shear(double across, double along, double nu) {
    const double rho = across / along;
    const double contraction = compute_contraction(nu);
    const double term = rho < 1.0 ? compute_narrow_term(rho) : compute_wide_term(rho);
    return 1.0 / (1.2 + contraction * contraction * term);
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
    const double mu = m * m / ((1.0 + m * m) * (1.0 + m * m));
    const double square = compute_contraction(nu) * compute_contraction(nu);
    shape.shear_factor_y = shape.shear_factor_z = 6.0 / (7.0 + square + mu * (20.0 - 4.0 * square));  // (S7)
    return shape;
}

ShapeConstants compute_rectangle(double width, double height, double nu) {
    ShapeConstants shape;
    shape.area = width * height;
    shape.second_moment_y = width * height * height * height / 12.0;
    shape.second_moment_z = height * width * width * width / 12.0;
    shape.torsion_constant = compute_rectangle_torsion(std::max(width, height), std::min(width, height));
    shape.shear_factor_y = compute_rectangle_shear(height, width, nu);
    shape.shear_factor_z = compute_rectangle_shear(width, height, nu);
    return shape;
}

}  // namespace gxrod
