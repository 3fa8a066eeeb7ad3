#pragma once

#include <cstdint>
#include <vector>

#include "linear/sparse_pattern.hpp"

namespace gxrod {

// Counts the negative eigenvalues of a symmetric matrix by the pivots of an elimination number by number,
// whose round-off is that of the largest entries. Elimination by blocks is faster, but takes inverses of
// blocks: where stiffnesses are 1e10 apart, its pivots can have the wrong sign. −1 if a pivot vanishes.
std::int64_t count_negative_pivots(const SparsePattern& pattern, const std::vector<double>& values);

}  // namespace gxrod
