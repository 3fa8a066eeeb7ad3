#pragma once

#include "solvers/equilibrium.hpp"
#include "solvers/path/bordered_solve.hpp"
#include "solvers/path/path_metric.hpp"

namespace gxrod {

// The search for an equilibrium in the unknowns and the load factor together, from the last accepted one.
struct PathProblem {
    PathVector prediction;  // the first increment
    // All further increments are orthogonal to these rows. There is a row for each further unknown: the load
    // factor, the amplitude of each column of `disturbances`, and the other load factor.
    std::vector<PathVector> rows;
    // Forces on the unknowns that are added to the residual, times their amplitudes. Empty except for reduced
    // equations.
    std::vector<Eigen::VectorXd> disturbances;
    // Another load factor, on which loads and moves of the system depend: the last further unknown. It holds
    // the initial value before, and the solution after.
    double* other_factor = nullptr;

    std::size_t amplitude_count() const { return disturbances.size() + (other_factor != nullptr ? 1 : 0); }
};

struct PathSolution {
    double load_factor = 0.0;
    Eigen::VectorXd amplitudes;  // amplitudes of the disturbances; last, the change of the other load factor
    // The direction of the path, not scaled: the derivative of the unknowns by the load factor, K⁻¹ (−∂R/∂λ)
    // with the tangent of the last iteration, and 1 for the load factor.
    PathVector direction;
};

// Solves (PA2) by Newton's method with bordered solves; state.time is the load factor of the last accepted
// equilibrium. The trial motions and the workspace's residual hold the solution. If the mixed tangent fails,
// tries the consistent one from the same prediction.
EquilibriumReport solve_path_equilibrium(const SolverSetup& setup,
                                         const PathProblem& problem,
                                         SolverWorkspace& workspace,
                                         State& state,
                                         PathSolution& solution);

// Computes the derivative of the residual by PathProblem's other load factor.
Eigen::VectorXd compute_other_gradient(const System& system,
                                       double& other_factor,
                                       double load_factor,
                                       const std::vector<double>& values,
                                       const State& state);

// Computes ∂R/∂λ at the trial motions from all loads, actions within sections and in joints, and moving
// supports; uses the values of the tangent.
Eigen::VectorXd compute_load_gradient(const System& system,
                                      double load_factor,
                                      const std::vector<double>& values,
                                      const State& state);

}  // namespace gxrod
