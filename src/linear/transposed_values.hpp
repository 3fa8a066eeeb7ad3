#pragma once

#include <vector>

#include "linear/sparse_pattern.hpp"

namespace gxrod {

// The values of the transposed matrix, whose entries the pattern must have too: any LinearSolver solves with
// them for the left side.
std::vector<double> transpose_values(const SparsePattern& pattern, const std::vector<double>& values);

}  // namespace gxrod
