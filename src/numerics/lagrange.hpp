#pragma once

#include <Eigen/Core>
#include <cmath>

// Lagrange polynomials on [−1, 1], and the Gauss-Lobatto points at which the nodes of an element lie.
namespace gxrod {

template <int Nodes>
using NodeValues = Eigen::Matrix<double, Nodes, 1>;

// Computes where the nodes of an element lie: the Gauss-Lobatto points, ±1 and the roots of P′ of degree
// Nodes − 1; equally spaced up to three nodes.
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

// Computes the Lagrange polynomials of any points: each is one at its own point and zero at the others.
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

// Computes N_I(ξ).
template <int Nodes>
NodeValues<Nodes> compute_shape_functions(double xi) {
    return compute_lagrange<Nodes>(compute_node_positions<Nodes>(), xi);
}

// Computes dN_I/dξ.
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
