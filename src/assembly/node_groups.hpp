#pragma once

#include <span>
#include <vector>

#include "assembly/equation_numbers.hpp"
#include "assembly/node_groups.hpp"
#include "linear/sparse_pattern.hpp"

namespace gxrod {

// The nodes that an element couples.
using NodeGroup = std::vector<int>;

// Computes the pattern that couples all unknowns of a group's nodes, and those attached to them, to each
// other.
SparsePattern compute_pattern(const EquationNumbers& equations, std::span<const NodeGroup> groups);

}  // namespace gxrod
