#pragma once

#include <vector>

#include "integrators/coupled_stages.hpp"
#include "linear/complex_as_real.hpp"
#include "linear/stacked_pattern.hpp"
#include "solvers/equilibrium.hpp"

namespace gxrod {

// What the stages of a step need that are found together, allocated once.
struct CoupledWorkspace {
    std::vector<Residual> residuals;    // of each stage
    std::vector<double> damping, mass;  // on the pattern, of the linearization without placements
    std::vector<double> real, imaginary;
    Eigen::VectorXcd factors;
    ComplexAsReal complex_solver;
    std::vector<Vec6> placement_errors, rate_errors;  // estimates for each node; of rates times Δt

    // Of all stages at once, if they had to be.
    std::unique_ptr<StackedPattern> stacked;
    std::unique_ptr<LinearSolver> stacked_solver;

    CoupledWorkspace(const System& system, LinearSolverKind kind);
};

// All stages of a step by Newton's method with one matrix, that of the step's start, for all of them and all
// iterations; where that does not converge, once more with the exact matrix of all stages. Each node's unknowns and equations are counted in axes that turn with it from stage to stage,
// so that stiff directions do not mix with soft ones when a model turns (docs/theory/newmark.md, (R5)).
// The trial becomes the end of the step; workspace.stage_powers and the estimates of errors are set.
EquilibriumReport solve_coupled_step(const System& system,
                                     const CoupledStages& scheme,
                                     const NewtonSettings& settings,
                                     const Stage& step,
                                     SolverWorkspace& workspace,
                                     State& state);

}  // namespace gxrod
