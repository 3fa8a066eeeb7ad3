#pragma once

#include "linear/chains/chain_kernels.hpp"
#include "linear/chains/chain_layout.hpp"
#include "linear/fronts/front_solver.hpp"
#include "linear/linear_solver.hpp"
#include "parallel/work_phases.hpp"

namespace gxrod {

// Eliminates the insides of chains block by block, in the order of EliminationOrder, and passes the system of
// the junctions, if there are any, to fronts. It does not pivot within blocks; instead it checks each
// solution against the system and refines it once if it is not good to round-off. If that does not suffice,
// or if a pivot vanishes, a general solver takes the whole system, and also finds singular equations. The
// factorized values must stay unchanged until the last solution.
class ChainSolver : public LinearSolver {
  public:
    explicit ChainSolver(const SparsePattern& pattern, const ThreadTeam& team = ThreadTeam::alone());

    Factorization factorize(const std::vector<double>& values) override;
    void solve(Eigen::VectorXd& right_hand_side) override;
    // Estimates the operations for the junctions alone: chains take far less.
    double estimate_flops() const override {
        return junction_solver_ ? junction_solver_->estimate_flops() : 0.0;
    }
    LinearSolverKind kind() const override { return LinearSolverKind::chains; }

    // False for a pattern without its diagonal; a general solver then takes all systems.
    bool works_by_blocks() const { return !steps_.empty() || junction_solver_; }
    // Returns the number of unknowns outside of chains.
    std::int64_t count_kept() const { return steps_.empty() ? pattern_->size() : junctions_.size(); }

  private:
    void lay_out_junctions(const BlockPartition& partition,
                           const EliminationOrder& order,
                           const ChainLayout& layout);
    ChainSteps steps_of(const ChainTask& task) const {
        return {steps_.data() + task.steps.first,
                task.steps.count,
                couplings_.data() + task.couplings.first,
                task.couplings.count,
                copies_.data() + task.copies.first};
    }
    bool eliminate();
    bool eliminate(const ChainTask& task, std::int64_t& negative_pivots);
    void go_forward(const ChainTask& task, double* x);
    bool factorize_junctions();
    Factorization factorize_generally();
    void solve_by_blocks(Eigen::VectorXd& x);
    void compute_residual(const Eigen::VectorXd& right_hand_side);
    bool is_solved(double tolerance) const;

    const SparsePattern* pattern_;
    const ThreadTeam* team_;
    const std::vector<double>* values_ = nullptr;
    ChainKernels kernels_;
    std::vector<ChainStep> steps_;
    std::vector<ChainCoupling> couplings_;
    std::vector<BlockCopy> copies_;
    std::vector<ChainTask> tasks_;
    std::vector<std::size_t> level_starts_;
    std::vector<BlockCopy> first_copies_;
    std::vector<BlockMerge> merges_;
    std::vector<VectorMerge> vector_merges_;
    std::vector<EntryRun> runs_;
    WorkPhases run_phases_;
    std::vector<double> blocks_;
    std::vector<double> apart_;  // sums for right-hand sides
    Eigen::VectorXd solution_;
    Eigen::VectorXd residual_;    // b − A x
    Eigen::VectorXd magnitudes_;  // |A| |x| + |b|

    SparsePattern junctions_;
    struct JunctionBlock {
        std::int64_t block, slot, stride;  // from column to column
        int rows, columns;
    };
    std::vector<JunctionBlock> junction_blocks_;
    std::vector<std::int64_t>
        junction_rows_;  // for each unknown of the junctions, its index in the whole system
    std::vector<double> junction_values_;
    Eigen::VectorXd junction_vector_;
    std::unique_ptr<FrontSolver> junction_solver_;

    std::unique_ptr<LinearSolver> general_;
    bool is_general_ = false;           // whether general_ has the last factorization
    std::int64_t negative_pivots_ = 0;  // pivots of the last elimination of blocks
};

}  // namespace gxrod
