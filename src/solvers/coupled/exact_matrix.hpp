#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "assembly/contact/contact_pairs.hpp"
#include "assembly/node_groups.hpp"
#include "linear/sparse_pattern.hpp"
#include "linear/stacked_pattern.hpp"
#include "solvers/coupled/stages.hpp"

namespace gxrod {

// The derivative of the equations of all stages by the placements of all stages, for steps in which the
// common matrix is too inexact. The size of the system is the model's times the number of stages. It is
// written in the unknowns that would decouple the common matrix (docs/theory/newmark.md, (R4)), so that
// elimination needs no exchange of equations here, either. Joints are met by positions. Where rods touch each
// other, its pattern has their pairs of elements in addition, and changes with them.
class ExactMatrix {
  public:
    ExactMatrix(const System& system, const CoupledStages& scheme, LinearSolverKind kind);

    // Factorizes it at the present stages. Returns false if it is singular.
    bool factorize(const StagesOfStep& stages, SolverWorkspace& workspace);
    // Solves for the increments of each stage with minus the residuals, in global axes.
    void solve(const StagesOfStep& stages,
               const std::vector<Residual>& residuals,
               SolverWorkspace& workspace,
               std::vector<Eigen::VectorXd>& increments);

    // Returns the tangent of a stage by its own placements, which scales the equations of its joints.
    const std::vector<double>& values_of(std::size_t stage) const { return of_stages_[stage]; }

  private:
    // Computes the blocks of rods that touch each other at each stage, and makes a pattern that has them.
    void find_pairs(const StagesOfStep& stages, SolverWorkspace& workspace);
    void build();
    // Returns block_ on the pattern that has pairs, with these blocks.
    const std::vector<double>& spread(const StagesOfStep& stages, const std::vector<PairBlock>& blocks);
    // Sets values_ to the blocks of the stacked system; the first index counts equations.
    void assemble(const StagesOfStep& stages, SolverWorkspace& workspace);

    const System* system_;
    LinearSolverKind kind_;
    int count_;
    std::vector<NodeGroup> groups_;              // sorted; pairs of elements that the pattern has
    std::vector<std::vector<PairBlock>> pairs_;  // [stage × count_ + stage by whose placements]
    std::optional<SparsePattern> paired_;        // with the groups, if there are any
    std::vector<std::int64_t> places_;           // of the system's values in it
    std::optional<StackedPattern> stacked_;
    std::unique_ptr<LinearSolver> solver_;
    Eigen::MatrixXd to_equations_, from_unknowns_;  // transformations of the stages
    std::vector<std::vector<double>> blocks_;       // equations of all stages, unknowns of one
    std::vector<std::vector<double>> of_stages_;    // equations and unknowns of the same stage
    std::vector<double> block_, spread_, values_;
};

}  // namespace gxrod
