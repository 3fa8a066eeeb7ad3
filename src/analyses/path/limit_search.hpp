#pragma once

#include "analyses/path/path_search.hpp"

namespace gxrod {

// Finds a limit point from the last accepted limit point, by (PA7) of docs/theory/paths.md:
// work.limit_load_factor is free as well. `prediction` is the first increment; the others are orthogonal to
// `row`, as in solve_path_step. The trial's direction is the chord from the last limit point. If none is
// found, the load factor keeps its value.
EquilibriumReport solve_limit_step(PathContext& work,
                                   const PathVector& prediction,
                                   const PathVector& row,
                                   PathTrial& trial);

// Computes the rate of the unknowns by the parameter along limit points, at the last accepted one; the
// workspace has its residual. Returns nullopt if that is not a limit point: where the loads of the load
// factor do no work on the soft shape.
std::optional<Eigen::VectorXd> find_limit_rate(PathContext& work);

}  // namespace gxrod
