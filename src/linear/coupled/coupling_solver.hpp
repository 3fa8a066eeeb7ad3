#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "linear/coupled/near_inverse.hpp"
#include "linear/linear_solver.hpp"

namespace gxrod {

// A dense matrix to be added at these unknowns; −1 for unknowns that are left out.
struct CouplingBlock {
    std::vector<std::int64_t> unknowns;
    Eigen::MatrixXd matrix;
};

// Solves (K + Σ Rᵀ B R) x = b, where blocks B couple unknowns that K does not couple, such as rods that touch
// each other. K is factorized. Adjacent blocks are combined, and each is a product Q S of few columns and
// rows, Q orthonormal. With g = S R x, the forces of the blocks, GMRES solves
//   g + S R K⁻¹ Rᵀ Q g = S R K⁻¹ b,
// whose residual is the residual of the whole system. The preconditioner is each block alone, with the
// inverse of K near it. It takes a few dozen solutions with K, where factors of the whole system would fill
// in.
class CouplingSolver {
  public:
    // Both must outlive this.
    CouplingSolver(const SparsePattern& pattern, const ThreadTeam& team);

    // Factorizes K on the pattern. Returns false if K is singular or not finite.
    bool factorize(const std::vector<double>& values, std::vector<CouplingBlock> blocks);
    // Replaces the right-hand side by the solution, up to a residual of `tolerance` times its norm; returns
    // false, and leaves it unchanged, if iterations do not converge. For Newton's method 0.01 suffices: two
    // steps of 300 rods that fall on each other take 60 of its iterations with 0.01 and 58 with 1e-6, and per
    // solution 22 iterations of GMRES instead of 56.
    bool solve(Eigen::VectorXd& right_hand_side, double tolerance = 1e-2);

    // Whether the inverse is cheap enough.
    bool is_suitable() const;
    int iterations() const { return iterations_; }  // iterations of the last solution

  private:
    struct Block {
        std::vector<std::int64_t> unknowns;
        Eigen::MatrixXd Q, S;
        Eigen::MatrixXd preconditioner;  // (1 + S W Q)⁻¹
        Eigen::Index first = 0;          // index among the forces
        Eigen::Index first_unknown = 0;  // index among the unknowns of all blocks, each with its own
    };
    Eigen::VectorXd gather(const Eigen::VectorXd& x) const;
    Eigen::VectorXd precondition(const Eigen::VectorXd& forces) const;
    void subtract(const Eigen::VectorXd& forces, Eigen::VectorXd& x) const;

    const ThreadTeam* team_;
    std::unique_ptr<LinearSolver> solver_;
    NearInverse inverse_;
    std::vector<Block> blocks_;
    Eigen::Index force_count_ = 0, unknown_count_ = 0, largest_ = 0;  // largest_: most unknowns of a block
    std::vector<double> values_;                                      // values of K, for its solutions
    int iterations_ = 0;
};

}  // namespace gxrod
