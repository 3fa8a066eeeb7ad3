#pragma once

#include <numbers>
#include <optional>

#include "solvers/path/path_newton.hpp"
#include "solvers/path/path_tangent.hpp"
#include "state/records/path_record.hpp"

namespace gxrod {

// The largest angle between the directions at both ends of a step, and between a branch and the shape along
// which it starts.
inline constexpr double widest_path_angle = 25.0 * std::numbers::pi / 180.0;

// The context of a search for equilibria near the last accepted one of a path.
struct PathContext {
    const System& system;
    const Integrator& integrator;
    NewtonSettings newton;
    const PathMetric& metric;
    bool is_symmetric;  // whether the tangent is symmetric: all loads have a potential
    SolverWorkspace& workspace;
    State& state;
    int iterations = 0;  // iterations of all its searches
    // PathSettings::limit_load_factor for a path of limit points: then the search finds limit points.
    double* limit_load_factor = nullptr;
};

// An equilibrium; the trial motions hold it.
struct PathTrial {
    double step = 0.0;  // arc length from the last accepted one
    double load_factor = 0.0;
    PathVector direction;      // direction of the path, of unit length
    std::int64_t pivots = -1;  // −1: not counted
    double residual = 0.0;
    int effort = 0;  // iterations, a measure for the choice of the step
};

// Finds the equilibrium with the first increment `prediction` and further increments orthogonal to `row`. The
// workspace has its residual. The trial's direction lies within 90° of the increment and comes from the last
// iteration's tangent.
EquilibriumReport solve_path_step(PathContext& work,
                                  const PathVector& prediction,
                                  const PathVector& row,
                                  PathTrial& trial);

// Finds the equilibrium a step of this length along a direction. Direction and pivots then come from the
// tangent at the equilibrium itself, whose factors the workspace has. Returns false if it was not found.
bool solve_exact_step(PathContext& work, const PathVector& direction, double step, PathTrial& trial);

// Sets the trial motions to the last accepted motions plus these movements, at this load factor. Returns
// false if something overlaps there; then the residual is not computed.
bool place_trial(PathContext& work, const std::vector<Vec6>& movement, double load_factor);

}  // namespace gxrod
