#pragma once

#include <span>

// Rules of Gauss and Kronrod on [−1, 1]: of 2n + 1 points, exact for polynomials of degree 3n + 1, of which n
// are Gauss' (exact to 2n − 1), so that one set of values gives two integrals and by their difference an
// error. A. S. Kronrod, Nodes and weights of quadrature formulas (1965); the points are roots of P_n and of
// the Stieltjes polynomial E_{n+1}, here from 60 digits.
namespace gxrod {

// A point at ξ ≤ 0; but for ξ = 0 another one is at −ξ.
struct KronrodPoint {
    double xi;
    double weight;
    double gauss_weight;  // 0 where Gauss' rule has no point
};

// Of n = 2, 3, 4, 5 or 7 points of Gauss.
std::span<const KronrodPoint> find_kronrod_rule(std::size_t gauss_points);

}  // namespace gxrod
