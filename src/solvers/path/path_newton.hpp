#pragma once

#include "solvers/equilibrium.hpp"
#include "solvers/path/bordered_solve.hpp"
#include "solvers/path/path_metric.hpp"

namespace gxrod {

// An equilibrium that is sought in the unknowns and the load factor together, from the last accepted one.
struct PathProblem {
    PathVector prediction;  // the first increment
    // All further increments are orthogonal to these rows: as many as there are further unknowns, the load
    // factor, one amplitude of each column of `disturbances`, and the other load factor.
    std::vector<PathVector> rows;
    // Forces on the unknowns that are added to the residual, times their amplitudes. Empty but for reduced
    // equations.
    std::vector<Eigen::VectorXd> disturbances;
    // Another load factor, on which loads and moves of the system rest: a further unknown, the last one. It
    // starts from the value it has and holds that of the solution.
    double* other_factor = nullptr;

    std::size_t amplitude_count() const { return disturbances.size() + (other_factor != nullptr ? 1 : 0); }
};

struct PathSolution {
    double load_factor = 0.0;
    Eigen::VectorXd amplitudes;  // of the disturbances; last, the change of the other load factor
    // How the unknowns follow the load factor, and by one of the rows alone: K⁻¹ (−∂R/∂λ) of the last
    // iteration's tangent. Not scaled.
    PathVector direction;
};

// Newton's method for (PA2) by bordered solves; state.time is the load factor of the last accepted
// equilibrium. The trial motions and the workspace's residual are those of the solution. Where the mixed
// tangent fails, the consistent one is tried from the same prediction.
EquilibriumReport solve_path_equilibrium(const System& system,
                                         const Integrator& integrator,
                                         const NewtonSettings& settings,
                                         const PathProblem& problem,
                                         SolverWorkspace& workspace,
                                         State& state,
                                         PathSolution& solution);

// By another load factor, as PathProblem has it.
Eigen::VectorXd compute_other_gradient(const System& system,
                                       double& other_factor,
                                       double load_factor,
                                       const std::vector<double>& values,
                                       const State& state);

// ∂R/∂λ of the trial motions by all that acts on them, within sections and in joints too, and by supports
// that move; from the values of their tangent.
Eigen::VectorXd compute_load_gradient(const System& system,
                                      double load_factor,
                                      const std::vector<double>& values,
                                      const State& state);

}  // namespace gxrod
