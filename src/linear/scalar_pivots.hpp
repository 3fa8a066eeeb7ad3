#pragma once

#include <cstdint>
#include <vector>

#include "linear/sparse_pattern.hpp"

namespace gxrod {

// Counts the negative eigenvalues of a symmetric matrix by the pivots of scalar elimination, whose round-off
// is relative to the largest entries. Elimination by blocks is faster, but takes inverses of blocks: if
// stiffnesses are 1e10 apart, its pivots can have the wrong sign. Returns −1 if a pivot vanishes.
std::int64_t count_negative_pivots(const SparsePattern& pattern, const std::vector<double>& values);

}  // namespace gxrod
