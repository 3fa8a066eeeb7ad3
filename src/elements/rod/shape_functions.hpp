#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <numbers>

// Lagrange polynomials and Gauss-Legendre rules on [−1, 1].
namespace gxrod {

struct QuadraturePoint {
    double xi;
    double weight;
};

struct LegendreValue {
    double value;
    double slope;
};

// P_n(ξ) and its derivative, |ξ| < 1, by the three-term recurrence.
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

// The n-point Gauss-Legendre rule, ascending, exact for polynomials of degree 2n − 1: roots of P_n by
// Newton's method from the usual asymptotic guess.
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

template <int Nodes>
using NodeValues = Eigen::Matrix<double, Nodes, 1>;

// Where the nodes of an element lie: the Gauss-Lobatto points, ±1 and the roots of P′ of degree Nodes − 1;
// equally spaced up to three nodes.
template <int Nodes>
NodeValues<Nodes> compute_node_positions() {
    static_assert(Nodes >= 2 && Nodes <= 5);
    NodeValues<Nodes> at;
    if constexpr (Nodes == 2) {
        at << -1.0, 1.0;
    } else if constexpr (Nodes == 3) {
        at << -1.0, 0.0, 1.0;
    } else if constexpr (Nodes == 4) {
        at << -1.0, -std::sqrt(0.2), std::sqrt(0.2), 1.0;
    } else {
        at << -1.0, -std::sqrt(3.0 / 7.0), 0.0, std::sqrt(3.0 / 7.0), 1.0;
    }
    return at;
}

// The Lagrange polynomials of any points: one at its own, zero at the others.
template <int Points>
NodeValues<Points> compute_lagrange(const NodeValues<Points>& at, double xi) {
    NodeValues<Points> values = NodeValues<Points>::Ones();
    for (int i = 0; i < Points; ++i) {
        for (int j = 0; j < Points; ++j) {
            if (j != i) values[i] *= (xi - at[j]) / (at[i] - at[j]);
        }
    }
    return values;
}

// N_I(ξ).
template <int Nodes>
NodeValues<Nodes> compute_shape_functions(double xi) {
    return compute_lagrange<Nodes>(compute_node_positions<Nodes>(), xi);
}

// dN_I/dξ.
template <int Nodes>
NodeValues<Nodes> compute_shape_slopes(double xi) {
    const NodeValues<Nodes> at = compute_node_positions<Nodes>();
    NodeValues<Nodes> slope = NodeValues<Nodes>::Zero();
    for (int i = 0; i < Nodes; ++i) {
        for (int k = 0; k < Nodes; ++k) {
            if (k == i) continue;
            double product = 1.0 / (at[i] - at[k]);
            for (int j = 0; j < Nodes; ++j) {
                if (j != i && j != k) product *= (xi - at[j]) / (at[i] - at[j]);
            }
            slope[i] += product;
        }
    }
    return slope;
}

}  // namespace gxrod
