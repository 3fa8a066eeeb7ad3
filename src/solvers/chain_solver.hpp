#pragma once

#include "solvers/chain_kernels.hpp"
#include "solvers/elimination_order.hpp"
#include "solvers/linear_solver.hpp"

namespace gxrod {

struct ChainLayout;

// Eliminates the insides of chains block by block, by the order that EliminationOrder finds, and leaves the
// system of the junctions, if there are any, to a general solver. Pivots are sought within no block; instead
// each solution is checked against the system, refined once if it is not good to round-off, and where that
// does not suffice, as where a pivot vanishes, the whole system goes to a general solver, which also says
// what is singular. The values that were factorized must stay until the last solution.
class ChainSolver : public LinearSolver {
  public:
    explicit ChainSolver(const SparsePattern& pattern);

    Factorization factorize(const std::vector<double>& values) override;
    void solve(Eigen::VectorXd& right_hand_side) override;
    LinearSolverKind kind() const override { return LinearSolverKind::chains; }

    // The unknowns that are left to a general solver.
    std::int64_t count_kept() const { return steps_.empty() ? pattern_->size() : junctions_.size(); }

  private:
    void lay_out_junctions(const BlockPartition& partition,
                           const EliminationOrder& order,
                           const ChainLayout& layout);
    ChainSteps chain() const {
        return {steps_.data(), static_cast<std::int64_t>(steps_.size()), couplings_.data(), copies_.data()};
    }
    bool factorize_junctions();
    Factorization factorize_generally();
    void solve_by_blocks(Eigen::VectorXd& x);
    void compute_residual(const Eigen::VectorXd& right_hand_side);
    bool is_round_off() const;

    const SparsePattern* pattern_;
    const std::vector<double>* values_ = nullptr;
    ChainKernels kernels_;
    std::vector<ChainStep> steps_;
    std::vector<ChainCoupling> couplings_;
    std::vector<BlockCopy> copies_;
    std::vector<EntryRun> runs_;
    std::vector<double> blocks_;
    Eigen::VectorXd solution_;
    Eigen::VectorXd residual_;    // b − A x
    Eigen::VectorXd magnitudes_;  // |A| |x| + |b|

    SparsePattern junctions_;
    struct JunctionBlock {
        std::int64_t block, slot, stride;  // from column to column
        int rows, columns;
    };
    std::vector<JunctionBlock> junction_blocks_;
    std::vector<std::int64_t> junction_rows_;  // of each unknown of the junctions, that of the whole system
    std::vector<double> junction_values_;
    Eigen::VectorXd junction_vector_;
    std::unique_ptr<LinearSolver> junction_solver_;

    std::unique_ptr<LinearSolver> general_;
    bool is_general_ = false;  // whether it has the last factorization
};

}  // namespace gxrod
