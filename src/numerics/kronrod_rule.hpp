#pragma once

#include <span>

// Gauss-Kronrod rules on [−1, 1] with 2n + 1 points, exact for polynomials of degree 3n + 1. n of the points
// are Gauss points (exact to 2n − 1), so one set of values gives two integrals, and their difference an
// error. A. S. Kronrod, Nodes and weights of quadrature formulas (1965); the points are roots of P_n and of
// the Stieltjes polynomial E_{n+1}, here from 60 digits.
namespace gxrod {

// A point at ξ ≤ 0. Unless ξ = 0, another point is at −ξ.
struct KronrodPoint {
    double xi;
    double weight;
    double gauss_weight;  // 0 if it is not a Gauss point
};

// Finds the rule with n = 2, 3, 4, 5 or 7 Gauss points.
std::span<const KronrodPoint> find_kronrod_rule(std::size_t gauss_points);

}  // namespace gxrod
