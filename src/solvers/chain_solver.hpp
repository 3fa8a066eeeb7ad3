#pragma once

#include "solvers/elimination_order.hpp"
#include "solvers/linear_solver.hpp"

namespace gxrod {

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
    // A block of the matrix and where it is worked on.
    struct Source {
        std::int64_t first;        // its first entry among the values
        std::int64_t stride;       // from column to column there
        std::int64_t block;        // among blocks_
        std::int64_t row, column;  // its first ones
        int rows, columns;
    };
    // How a block is coupled to a neighbour that remains, by A_tu and A_ut, and where that one's diagonal is.
    struct Coupling {
        std::int64_t to, from, diagonal;
        std::int64_t row;  // first one of the neighbour
        int size = 0;      // 0: no neighbour
    };
    struct Step {
        std::int64_t diagonal, row;
        int size;
        std::array<Coupling, 2> neighbours;
        std::int64_t across, back;  // A_uv and A_vu of the two neighbours
        bool fills;                 // these were zero
    };

    class Layout;

    void lay_out_junctions(const BlockPartition& partition, const EliminationOrder& order, Layout& layout);
    bool eliminate();
    bool eliminate(const Step& step);
    bool factorize_junctions();
    Factorization factorize_generally();
    Eigen::VectorXd solve_by_blocks(Eigen::VectorXd vector);
    Eigen::VectorXd compute_residual(const Eigen::VectorXd& right_hand_side, const Eigen::VectorXd& x);
    bool is_round_off(const Eigen::VectorXd& residual) const;

    const SparsePattern* pattern_;
    const std::vector<double>* values_ = nullptr;
    std::vector<Source> sources_;
    std::vector<Step> steps_;
    std::vector<double> blocks_;
    Eigen::VectorXd magnitudes_;  // |A| |x| + |b|

    SparsePattern junctions_{{0}, {}};
    struct JunctionBlock {
        std::int64_t block, slot, stride;  // from column to column
        int rows, columns;
    };
    std::vector<JunctionBlock> junction_blocks_;
    std::vector<std::int64_t> junction_rows_;  // of each unknown of the junctions, that of the whole system
    std::vector<double> junction_values_;
    std::unique_ptr<LinearSolver> junction_solver_;

    std::unique_ptr<LinearSolver> general_;
    bool is_general_ = false;  // whether it has the last factorization
};

}  // namespace gxrod
