#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "assembly/equation_numbers.hpp"
#include "assembly/sparse_pattern.hpp"
#include "elements/element.hpp"

// From an element's matrix to the global one, and from nodal vectors to equations and back.
namespace gxrod {

// The slot of each entry of an element's matrix, column by column; −1 where a support holds the row or
// column.
void find_slots(std::span<const int> nodes,
                const EquationNumbers& equations,
                const SparsePattern& pattern,
                std::span<std::int64_t> slots);

template <int Nodes>
using ElementSlots = std::array<std::int64_t, 36 * Nodes * Nodes>;

template <int Nodes>
ElementSlots<Nodes> compute_slots(const std::array<int, Nodes>& nodes,
                                  const EquationNumbers& equations,
                                  const SparsePattern& pattern) {
    ElementSlots<Nodes> slots;
    find_slots(nodes, equations, pattern, slots);
    return slots;
}

// Turns the rows and columns of nodes whose supports have their own axes into those.
template <class Matrix>
void turn_to_own_axes(std::span<const int> nodes, const EquationNumbers& equations, Matrix& matrix) {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (!equations.supports().has_own_axes(nodes[i])) continue;
        const Mat3& Q = equations.supports().axes(nodes[i]);
        for (std::size_t part = 2 * i; part < 2 * i + 2; ++part) {
            auto rows = matrix.template middleRows<3>(static_cast<Eigen::Index>(3 * part));
            rows = (Q.transpose() * rows).eval();
            auto columns = matrix.template middleCols<3>(static_cast<Eigen::Index>(3 * part));
            columns = (columns * Q).eval();
        }
    }
}

// Adds an element's matrix, column by column, to the values of the global one.
inline void add_to_values(const double* matrix,
                          std::span<const std::int64_t> slots,
                          std::vector<double>& values) {
    for (std::size_t entry = 0; entry < slots.size(); ++entry) {
        if (slots[entry] >= 0) values[slots[entry]] += matrix[entry];
    }
}

// Adds an element's vector to its nodes.
template <int Nodes>
void add_to_nodes(const NodalVector<Nodes>& force,
                  const std::array<int, Nodes>& nodes,
                  std::vector<Vec6>& nodal) {
    for (int i = 0; i < Nodes; ++i) nodal[nodes[i]] += force.template segment<6>(6 * i);
}

// The components that have equations, in the axes of those.
Eigen::VectorXd gather(const std::vector<Vec6>& nodal, const EquationNumbers& equations);

}  // namespace gxrod
