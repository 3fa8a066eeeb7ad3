#pragma once

#include "linear/complex_as_real.hpp"
#include "solvers/coupled/stages.hpp"

namespace gxrod {

// One matrix for all stages and iterations of a step, taken at its start (docs/theory/newmark.md, (R3) to
// (R5)): one system of the model's size for each eigenvalue of the scheme, in axes that turn with the nodes
// from stage to stage.
class CommonMatrix {
  public:
    CommonMatrix(const System& system, LinearSolverKind kind);

    // Factorizes the matrix of the last accepted motions. Returns false, and reports it, if it is singular.
    bool factorize(const StagesOfStep& stages, SolverWorkspace& workspace, EquilibriumReport& report);
    // Solve for the increments of each stage with minus the residuals, nodes in the axes at the start of the
    // step, and for the increments of a stage's nodes in global axes.
    void solve(const StagesOfStep& stages,
               const std::vector<Residual>& residuals,
               SolverWorkspace& workspace,
               std::vector<Eigen::VectorXd>& increments);
    static void turn_increments(const StagesOfStep& stages, std::size_t j, std::vector<Vec6>& increments);
    // Estimates the errors of each node, of placements and of rates times Δt, (R6).
    void estimate_errors(const StagesOfStep& stages,
                         SolverWorkspace& workspace,
                         std::vector<Vec6>& placements,
                         std::vector<Vec6>& rates) const;

  private:
    void turn_joints(const System& system, double half_angle);

    std::vector<double> damping_, mass_;  // on the pattern, of the linearization without placements
    std::vector<double> real_, imaginary_;
    Eigen::VectorXcd factors_;
    ComplexAsReal complex_solver_;
    std::vector<Vec6> nodal_;
};

}  // namespace gxrod
