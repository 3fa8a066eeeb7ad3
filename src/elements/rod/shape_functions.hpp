#pragma once

#include <Eigen/Core>
#include <array>
#include <cassert>
#include <cmath>

// Lagrange polynomials and Gauss-Legendre rules on [−1, 1].
namespace gxrod {

struct QuadraturePoint {
    double xi;
    double weight;
};

// The n-point Gauss-Legendre rule, n = 1 … 3, exact for polynomials of degree 2n − 1.
template <int Points>
std::array<QuadraturePoint, Points> compute_gauss_rule() {
    static_assert(Points >= 1 && Points <= 3);
    if constexpr (Points == 1) {
        return {{{0.0, 2.0}}};
    } else if constexpr (Points == 2) {
        const double xi = 1.0 / std::sqrt(3.0);
        return {{{-xi, 1.0}, {xi, 1.0}}};
    } else {
        const double xi = std::sqrt(0.6);
        return {{{-xi, 5.0 / 9.0}, {0.0, 8.0 / 9.0}, {xi, 5.0 / 9.0}}};
    }
}

template <int Nodes>
using NodeValues = Eigen::Matrix<double, Nodes, 1>;

// Where the nodes of an element lie, equally spaced.
template <int Nodes>
NodeValues<Nodes> compute_node_positions() {
    return NodeValues<Nodes>::LinSpaced(-1.0, 1.0);
}

// N_I(ξ): one at node I, zero at the others.
template <int Nodes>
NodeValues<Nodes> compute_shape_functions(double xi) {
    const NodeValues<Nodes> at = compute_node_positions<Nodes>();
    NodeValues<Nodes> shape = NodeValues<Nodes>::Ones();
    for (int i = 0; i < Nodes; ++i) {
        for (int j = 0; j < Nodes; ++j) {
            if (j != i) shape[i] *= (xi - at[j]) / (at[i] - at[j]);
        }
    }
    return shape;
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
