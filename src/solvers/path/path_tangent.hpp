#pragma once

#include <optional>

#include "solvers/equilibrium.hpp"
#include "solvers/path/path_metric.hpp"

namespace gxrod {

// The tangent of a path at an equilibrium, by the consistent tangent matrix.
struct PathTangent {
    PathVector direction;              // direction of unit length
    std::int64_t negative_pivots = 0;  // −1: not counted
};

// Computes it at the trial motions; the workspace has their residual, and afterwards the factors of K. The
// direction lies within 90° of `along`. A bordered solve with refinement makes its load factor exact even if
// K is nearly singular. nullopt if K has no inverse.
std::optional<PathTangent> compute_path_tangent(const System& system,
                                                const Integrator& integrator,
                                                const PathMetric& metric,
                                                const PathVector& along,
                                                double load_factor,
                                                SolverWorkspace& workspace,
                                                State& state);

// Computes the consistent tangent at the trial motions into the workspace's values.
void compute_consistent_tangent(const System& system,
                                const Integrator& integrator,
                                double load_factor,
                                SolverWorkspace& workspace,
                                State& state);

}  // namespace gxrod
