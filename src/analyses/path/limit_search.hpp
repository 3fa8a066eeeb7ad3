#pragma once

#include "analyses/path/path_search.hpp"

namespace gxrod {

// The limit point whose first increment this is and whose further ones are orthogonal to `row`, as
// solve_path_step has it, where work.limit_load_factor is free as well: (PA7) of docs/theory/paths.md. From a
// limit point, the last accepted one. Its direction is the chord from there. If none was found, the load
// factor has the value that it had.
EquilibriumReport solve_limit_step(PathContext& work,
                                   const PathVector& prediction,
                                   const PathVector& row,
                                   PathTrial& trial);

// How the unknowns follow the parameter along limit points, at the last accepted one; the workspace has its
// residual. nullopt if that is not a limit point: where the loads of the load factor do no work on the soft
// shape.
std::optional<Eigen::VectorXd> find_limit_rate(PathContext& work);

}  // namespace gxrod
