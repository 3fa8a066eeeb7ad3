#pragma once

#include <optional>

#include "solvers/equilibrium.hpp"
#include "solvers/path/path_metric.hpp"

namespace gxrod {

// At an equilibrium of a path, by its consistent tangent.
struct PathTangent {
    PathVector direction;              // of unit length
    std::int64_t negative_pivots = 0;  // −1: not counted
};

// Of the trial motions; the workspace has their residual, and the factors of K afterwards. The direction is
// that within 90° of `along`, by a bordered solve with refinement, so that its load factor's part is as exact
// as the tangent where that is nearly singular. nullopt if the tangent has no inverse.
std::optional<PathTangent> compute_path_tangent(const System& system,
                                                const Integrator& integrator,
                                                const PathMetric& metric,
                                                const PathVector& along,
                                                double load_factor,
                                                SolverWorkspace& workspace,
                                                State& state);

// The consistent tangent of the trial motions into the workspace's values.
void compute_consistent_tangent(const System& system,
                                const Integrator& integrator,
                                double load_factor,
                                SolverWorkspace& workspace,
                                State& state);

}  // namespace gxrod
