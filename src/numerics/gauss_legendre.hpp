#pragma once

#include <array>
#include <cassert>
#include <cmath>
#include <numbers>
#include <vector>

// Gauss-Legendre rules on [−1, 1].
namespace gxrod {

struct QuadraturePoint {
    double xi;
    double weight;
};

struct LegendreValue {
    double value;
    double slope;
};

// Computes P_n(ξ) and its derivative for |ξ| < 1, by the three-term recurrence.
inline LegendreValue compute_legendre(int n, double xi) {
    double before = 1.0;
    double value = xi;
    for (int k = 2; k <= n; ++k) {
        const double next = ((2 * k - 1) * xi * value - (k - 1) * before) / k;
        before = value;
        value = next;
    }
    return {value, n * (xi * value - before) / (xi * xi - 1.0)};
}

// Computes the n-point Gauss-Legendre rule, ascending, exact for polynomials of degree 2n − 1: roots of P_n
// by Newton's method from the usual asymptotic guess.
template <int Points>
std::array<QuadraturePoint, Points> compute_gauss_rule() {
    static_assert(Points >= 1);
    std::array<QuadraturePoint, Points> rule;
    for (int i = 0; i < Points; ++i) {
        double xi = -std::cos(std::numbers::pi * (i + 0.75) / (Points + 0.5));
        if (2 * i + 1 == Points) xi = 0.0;
        for (int iteration = 0; iteration < 5 && xi != 0.0; ++iteration) {
            const LegendreValue p = compute_legendre(Points, xi);
            xi -= p.value / p.slope;
        }
        const double slope = compute_legendre(Points, xi).slope;
        rule[i] = {xi, 2.0 / ((1.0 - xi * xi) * slope * slope)};
    }
    return rule;
}

// Returns the rule with a number of points, from 1 to 5, that is known at run time.
inline std::vector<QuadraturePoint> list_gauss_rule(int points) {
    const auto list = [](const auto& rule) { return std::vector<QuadraturePoint>(rule.begin(), rule.end()); };
    switch (points) {
        case 1:
            return list(compute_gauss_rule<1>());
        case 2:
            return list(compute_gauss_rule<2>());
        case 3:
            return list(compute_gauss_rule<3>());
        case 4:
            return list(compute_gauss_rule<4>());
        default:
            assert(points == 5);
            return list(compute_gauss_rule<5>());
    }
}

}  // namespace gxrod
