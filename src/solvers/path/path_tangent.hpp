#pragma once

#include <optional>
#include <vector>

#include "linear/linear_solver.hpp"
#include "linear/sparse_pattern.hpp"
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

// The tangent that a workspace has factorized for a path, with the blocks of rods that touch each other.
struct FactorizedTangent {
    LinearSolver& solver;
    const SparsePattern& pattern;
    const std::vector<double>& values;
};
FactorizedTangent factorized_tangent(const System& system, SolverWorkspace& workspace);

// Computes the tangent from the workspace's linearizations into its values, or its paired matrix.
void compute_tangent_on_path(const System& system,
                             double load_factor,
                             const State& state,
                             SolverWorkspace& workspace);

// Computes the consistent tangent at the trial motions into the workspace's values, or its paired matrix.
void compute_consistent_tangent(const System& system,
                                const Integrator& integrator,
                                double load_factor,
                                SolverWorkspace& workspace,
                                State& state);

}  // namespace gxrod
