#pragma once

#include <numbers>
#include <optional>

#include "solvers/path/path_newton.hpp"
#include "solvers/path/path_tangent.hpp"
#include "state/records/path_record.hpp"

namespace gxrod {

// Between the directions at both ends of a step, and between a branch and the shape that it starts along.
inline constexpr double widest_path_angle = 25.0 * std::numbers::pi / 180.0;

// What a search for equilibria near the last accepted one of a path works with.
struct PathContext {
    const System& system;
    const Integrator& integrator;
    NewtonSettings newton;
    const PathMetric& metric;
    bool is_symmetric;  // the tangent: all loads have a potential
    SolverWorkspace& workspace;
    State& state;
    int iterations = 0;  // of all its searches
    // Of a path of limit points, PathSettings::limit_load_factor: then equilibria are limit points.
    double* limit_load_factor = nullptr;
};

// An equilibrium that the trial motions hold.
struct PathTrial {
    double step = 0.0;  // arc length from the last accepted one
    double load_factor = 0.0;
    PathVector direction;      // of the path, of unit length
    std::int64_t pivots = -1;  // −1: not counted
    double residual = 0.0;
    int effort = 0;  // iterations, of which a step should need few
};

// The equilibrium whose first increment this is and whose further ones are orthogonal to `row`. The workspace
// has its residual. Its direction is that within 90° of the increment, by the last iteration's tangent.
EquilibriumReport solve_path_step(PathContext& work,
                                  const PathVector& prediction,
                                  const PathVector& row,
                                  PathTrial& trial);

// The same for a step of this length along a direction; then its direction and pivots by the tangent at the
// equilibrium itself, whose factors the workspace has. False if it was not found.
bool solve_exact_step(PathContext& work, const PathVector& direction, double step, PathTrial& trial);

// Makes these movements since the last accepted motions, at this load factor, the trial motions.
void place_trial(PathContext& work, const std::vector<Vec6>& movement, double load_factor);

}  // namespace gxrod
