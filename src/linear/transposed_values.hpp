#pragma once

#include <vector>

#include "linear/sparse_pattern.hpp"

namespace gxrod {

// Returns the values of the transposed matrix, whose entries must be in the pattern: with them any
// LinearSolver solves transposed systems.
std::vector<double> transpose_values(const SparsePattern& pattern, const std::vector<double>& values);

}  // namespace gxrod
