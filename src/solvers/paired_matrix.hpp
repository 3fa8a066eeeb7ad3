#pragma once

#include <memory>
#include <vector>

#include "assembly/contact/contact_pairs.hpp"
#include "assembly/system.hpp"
#include "linear/coupled/coupling_solver.hpp"
#include "linear/linear_solver.hpp"

namespace gxrod {

// The tangent of a model whose rods touch each other: its pattern is the system's and the changing pairs of
// elements that are near each other. The pattern of a step starts from the pairs that are near at its start,
// and grows within the step. If its factors fill in much, as in piles, the forces between rods are found by
// iterations (CouplingSolver); if these fail, the rest of the step is solved directly.
class PairedMatrix {
  public:
    // The system must outlive it.
    PairedMatrix(const System& system, LinearSolverKind kind) : system_(&system), kind_(kind) {}

    // From now on solves directly, to rounding, where Newton's method does not correct what iterations leave.
    void solve_directly() { is_direct_ = true; }

    // Starts a new step: the pattern becomes the pattern of these groups.
    void start(std::vector<NodeGroup> groups);
    // Sets the matrix from values on the system's pattern, and blocks of pairs in global axes.
    void set_values(const std::vector<double>& values, std::vector<PairBlock> blocks);
    // Returns all of the values that were set, on a pattern that has all groups.
    const std::vector<double>& assemble();
    const SparsePattern& pattern() const { return pattern_; }  // pattern of assemble
    // Returns the values that were factorized directly, and the solver that has their factors.
    const std::vector<double>& values() const { return values_; }
    LinearSolver& solver() { return *solver_; }
    Factorization factorize();
    // Solves in place. The result is not finite if the system is found to be singular.
    void solve(Eigen::VectorXd& right_hand_side);

    // Returns how often a pattern was made.
    int orderings() const { return orderings_; }
    bool is_iterative() const { return is_iterative_; }

  private:
    void build();
    bool wants_iterations() const;
    std::vector<CouplingBlock> list_couplings() const;
    Factorization factorize_directly();
    const std::vector<std::int64_t>& slots_of(const NodeGroup& group);

    const System* system_;
    LinearSolverKind kind_;
    std::vector<NodeGroup> groups_;                 // sorted
    std::vector<std::vector<std::int64_t>> slots_;  // slots of each group's matrix, once they are needed
    SparsePattern pattern_;
    std::vector<std::int64_t> places_;  // place of each value of the system's pattern
    std::unique_ptr<LinearSolver> solver_;
    std::vector<double> values_;         // with the blocks
    std::vector<double> system_values_;  // without the blocks
    std::vector<PairBlock> blocks_;      // in the axes of the unknowns
    std::unique_ptr<CouplingSolver> coupling_;
    bool is_stale_ = false;      // whether the pattern lacks groups
    bool is_direct_ = false;     // whether iterations are not wanted
    bool is_iterative_ = false;  // whether the last factorization was
    bool has_failed_ = false;    // whether iterations failed in this step
    int orderings_ = 0;
};

}  // namespace gxrod
