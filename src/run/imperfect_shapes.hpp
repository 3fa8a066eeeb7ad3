#pragma once

#include <vector>

#include "model/problem.hpp"
#include "model/settings/mode_kind.hpp"

namespace gxrod {

// Finds a mode, from 1, of a problem: of buckling under the loads of its first stage at t = 1, or of
// vibration without loads. Returns displacements and spins of all nodes, the largest component positive.
// Throws std::runtime_error with the reason if there is none.
std::vector<Vec6> find_imperfect_mode(const Problem& problem, ModeKind kind, int mode);

}  // namespace gxrod
