#pragma once

#include "solvers/coupled/common_matrix.hpp"
#include "solvers/coupled/exact_matrix.hpp"
#include "state/contact_trial.hpp"

namespace gxrod {

// Memory for stages of a step that are found together, allocated once.
struct CoupledWorkspace {
    std::vector<Residual> residuals;  // residual of each stage
    CommonMatrix common;
    std::unique_ptr<ExactMatrix> exact;               // from the first step on that needs it
    std::vector<ContactTrial> contacts;               // contact of each stage
    std::vector<Vec6> placement_errors, rate_errors;  // estimates for each node; of rates times Δt
    bool asks_for_positions = true;                   // whether the last step met joints by positions

    CoupledWorkspace(const System& system, LinearSolverKind kind) : common(system, kind) {}
};

// Solves all stages of a step by Newton's method with the common matrix. If that converges slowly or not at
// all, uses the exact matrix of all stages, and keeps it as long as increments fall fast and nothing touches.
// Increments of each stage are cut so that no gap closes. The trial becomes
// the end of the step; sets workspace.stage_powers and the estimates of errors.
EquilibriumReport solve_coupled_step(const System& system,
                                     const CoupledStages& scheme,
                                     const NewtonSettings& settings,
                                     const Stage& step,
                                     SolverWorkspace& workspace,
                                     State& state);

}  // namespace gxrod
