#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "assembly/equation_numbers.hpp"
#include "elements/element.hpp"
#include "linear/sparse_pattern.hpp"
#include "parallel/thread_team.hpp"

// Functions that take an element's matrix to the global one, and nodal vectors to equations and back.
namespace gxrod {

// Finds the slot of each entry of an element's matrix, column by column; −1 where a support holds the row or
// column.
void find_slots(std::span<const int> nodes,
                const EquationNumbers& equations,
                const SparsePattern& pattern,
                std::span<std::int64_t> slots);

// Consecutive entries of the global matrix.
struct EntryRange {
    std::int64_t first, last;  // last: one past the end

    void clear(std::vector<double>& values) const {
        std::fill(values.begin() + first, values.begin() + last, 0.0);
    }
};

// The places of an element's matrix among the values: a block for each pair of its nodes or, if a support
// holds or turns some of their unknowns, each entry by itself.
template <int Nodes>
struct ElementPlaces {
    struct Block {
        std::int64_t first;   // the entry in the block's first row and column
        std::int64_t stride;  // from column to column
    };
    std::array<Block, Nodes * Nodes> blocks;  // column by column
    std::vector<std::int64_t> slots;          // column by column; empty if the blocks are enough
};

template <int Nodes>
ElementPlaces<Nodes> find_places(const std::array<int, Nodes>& nodes,
                                 const EquationNumbers& equations,
                                 const SparsePattern& pattern) {
    ElementPlaces<Nodes> places{};
    if (!std::all_of(nodes.begin(), nodes.end(), [&](int node) { return equations.is_free(node); })) {
        places.slots.resize(36 * Nodes * Nodes);
        find_slots(nodes, equations, pattern, places.slots);
        return places;
    }
    for (int pair = 0; pair < Nodes * Nodes; ++pair) {
        const std::int64_t row = equations.of_node(nodes[pair % Nodes])[0];
        const std::int64_t column = equations.of_node(nodes[pair / Nodes])[0];
        places.blocks[pair] = {pattern.slot(row, column), pattern.block_of(column).stride};
    }
    return places;
}

// Turns the rows and columns of nodes whose supports have their own axes into these axes. A node below 0 is
// the ground.
template <class Matrix>
void turn_to_own_axes(std::span<const int> nodes, const EquationNumbers& equations, Matrix& matrix) {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (nodes[i] < 0 || !equations.supports().has_own_axes(nodes[i])) continue;
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

template <int Nodes>
void add_to_values(const NodalMatrix<Nodes>& matrix,
                   const ElementPlaces<Nodes>& places,
                   std::vector<double>& values) {
    if (!places.slots.empty()) return add_to_values(matrix.data(), places.slots, values);
    for (int pair = 0; pair < Nodes * Nodes; ++pair) {
        const auto [first, stride] = places.blocks[pair];
        for (int column = 0; column < 6; ++column) {
            double* target = &values[first + column * stride];
            const double* source = &matrix.coeffRef(6 * (pair % Nodes), 6 * (pair / Nodes) + column);
            for (int row = 0; row < 6; ++row) target[row] += source[row];
        }
    }
}

// Adds an element's vector to its nodes.
template <int Nodes>
void add_to_nodes(const NodalVector<Nodes>& force,
                  const std::array<int, Nodes>& nodes,
                  std::vector<Vec6>& nodal) {
    for (int i = 0; i < Nodes; ++i) nodal[nodes[i]] += force.template segment<6>(6 * i);
}

// Gathers the components that have equations, in the axes of the equations.
Eigen::VectorXd gather(const std::vector<Vec6>& nodal,
                       const EquationNumbers& equations,
                       const ThreadTeam& team = ThreadTeam::alone());

}  // namespace gxrod
