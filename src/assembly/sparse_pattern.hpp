#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "assembly/equation_numbers.hpp"

namespace gxrod {

// The nodes that an element ties together.
using NodeGroup = std::vector<int>;

// Where a sparse matrix can be non-zero, by compressed columns; rows ascend within a column. 64-bit indices.
struct SparsePattern {
    std::vector<std::int64_t> column_starts;
    std::vector<std::int64_t> rows;

    std::int64_t size() const { return static_cast<std::int64_t>(column_starts.size()) - 1; }
    std::int64_t nonzeros() const { return static_cast<std::int64_t>(rows.size()); }
    // The place of (row, column) among the values, which must be in the pattern.
    std::int64_t slot(std::int64_t row, std::int64_t column) const;
};

// The pattern in which all unknowns of a group's nodes are coupled to each other.
SparsePattern compute_pattern(const EquationNumbers& equations, std::span<const NodeGroup> groups);

}  // namespace gxrod
