#pragma once

#include <vector>

#include "model/problem.hpp"

namespace gxrod {

// Finds a buckling mode, from 1, of a problem under the loads of its first stage at t = 1: displacements and
// spins of all nodes, the largest component positive. Throws std::runtime_error with the reason if there is
// none.
std::vector<Vec6> find_buckling_mode(const Problem& problem, int mode);

}  // namespace gxrod
