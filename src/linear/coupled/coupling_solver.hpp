#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "linear/coupled/near_inverse.hpp"
#include "linear/linear_solver.hpp"

namespace gxrod {

// A dense matrix to be added at these unknowns; −1 of those that are left out.
struct CouplingBlock {
    std::vector<std::int64_t> unknowns;
    Eigen::MatrixXd matrix;
};

// Solves (K + Σ Rᵀ B R) x = b, where blocks B couple what K leaves apart, such as rods that touch each other.
// K is factorized. Blocks next to each other are taken together, and each is a product Q S of few columns and
// rows, Q orthonormal; of g = S R x, the forces of the blocks, GMRES solves
//   g + S R K⁻¹ Rᵀ Q g = S R K⁻¹ b,
// whose residual is that of the whole system. Each block alone, with the inverse of K next to it, is the
// preconditioner. Takes a few dozen solutions with K, where factors of the whole system would fill in.
class CouplingSolver {
  public:
    // Both must outlive it.
    CouplingSolver(const SparsePattern& pattern, const ThreadTeam& team);

    // Of K on the pattern. False if K is singular or not finite.
    bool factorize(const std::vector<double>& values, std::vector<CouplingBlock> blocks);
    // Replaces the right-hand side by the solution, up to a residual of `tolerance` times its norm; false,
    // and unchanged, if iterations do not converge. Newton's method corrects a hundredth: two steps of 300
    // rods that fall on each other take 60 of its iterations with that and 58 with a millionth, and 22
    // instead of 56 of these in each.
    bool solve(Eigen::VectorXd& right_hand_side, double tolerance = 1e-2);

    // Whether the inverse is cheap enough.
    bool is_suitable() const;
    int iterations() const { return iterations_; }  // of the last solution

  private:
    struct Block {
        std::vector<std::int64_t> unknowns;
        Eigen::MatrixXd Q, S;
        Eigen::MatrixXd preconditioner;  // (1 + S W Q)⁻¹
        Eigen::Index first = 0;          // among the forces
        Eigen::Index first_unknown = 0;  // among those of all blocks, each with its own
    };
    Eigen::VectorXd gather(const Eigen::VectorXd& x) const;
    Eigen::VectorXd precondition(const Eigen::VectorXd& forces) const;
    void subtract(const Eigen::VectorXd& forces, Eigen::VectorXd& x) const;

    const ThreadTeam* team_;
    std::unique_ptr<LinearSolver> solver_;
    NearInverse inverse_;
    std::vector<Block> blocks_;
    Eigen::Index force_count_ = 0, unknown_count_ = 0, largest_ = 0;  // unknowns of a block at most
    std::vector<double> values_;                                      // of K, for its solutions
    int iterations_ = 0;
};

}  // namespace gxrod
