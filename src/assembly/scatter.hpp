#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "assembly/equation_numbers.hpp"
#include "assembly/sparse_pattern.hpp"
#include "elements/element.hpp"

// From an element's matrix to the global one, and from nodal vectors to equations and back.
namespace gxrod {

// The slot of each entry of an element's matrix, column by column; −1 where a support holds the row or
// column.
template <int Nodes>
using ElementSlots = std::array<std::int64_t, 36 * Nodes * Nodes>;

template <int Nodes>
ElementSlots<Nodes> compute_slots(const std::array<int, Nodes>& nodes,
                                  const EquationNumbers& equations,
                                  const SparsePattern& pattern) {
    ElementSlots<Nodes> slots;
    std::size_t entry = 0;
    for (int column = 0; column < 6 * Nodes; ++column) {
        const std::int64_t column_equation = equations.of_node(nodes[column / 6])[column % 6];
        for (int row = 0; row < 6 * Nodes; ++row, ++entry) {
            const std::int64_t row_equation = equations.of_node(nodes[row / 6])[row % 6];
            const bool free = column_equation >= 0 && row_equation >= 0;
            slots[entry] = free ? pattern.slot(row_equation, column_equation) : -1;
        }
    }
    return slots;
}

// Adds an element's matrix to the values of the global one.
template <int Nodes>
void add_to_values(const NodalMatrix<Nodes>& matrix,
                   const ElementSlots<Nodes>& slots,
                   std::vector<double>& values) {
    for (std::size_t entry = 0; entry < slots.size(); ++entry) {
        if (slots[entry] >= 0) values[slots[entry]] += matrix.data()[entry];
    }
}

// Adds an element's vector to its nodes.
template <int Nodes>
void add_to_nodes(const NodalVector<Nodes>& force,
                  const std::array<int, Nodes>& nodes,
                  std::vector<Vec6>& nodal) {
    for (int i = 0; i < Nodes; ++i) nodal[nodes[i]] += force.template segment<6>(6 * i);
}

// The components that have equations.
Eigen::VectorXd gather(const std::vector<Vec6>& nodal, const EquationNumbers& equations);

}  // namespace gxrod
