#pragma once

#include <memory>
#include <vector>

#include "assembly/contact/contact_pairs.hpp"
#include "assembly/system.hpp"
#include "linear/coupled/coupling_solver.hpp"
#include "linear/linear_solver.hpp"

namespace gxrod {

// A tangent of a model whose rods touch each other: its own pattern and that of pairs of elements that are
// near each other, which change. The pattern of a step follows from what is near at its start; it grows
// within the step. Where its factors fill in much, as in piles, the system is solved for the forces between
// rods by iterations (CouplingSolver), and directly in the rest of a step in which these fail.
class PairedMatrix {
  public:
    // The system must outlive it.
    PairedMatrix(const System& system, LinearSolverKind kind) : system_(&system), kind_(kind) {}

    // For a new step: the pattern becomes that of these groups.
    void start(std::vector<NodeGroup> groups);
    // Of values on the system's pattern, and blocks of pairs in global axes.
    void set_values(const std::vector<double>& values, std::vector<PairBlock> blocks);
    // All of the values that were set, on a pattern that has all groups.
    const std::vector<double>& assemble();
    const SparsePattern& pattern() const { return pattern_; }  // of assemble
    Factorization factorize();
    // Not finite where the system is found to be singular.
    void solve(Eigen::VectorXd& right_hand_side);

    // How often a pattern was made.
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
    std::vector<std::vector<std::int64_t>> slots_;  // of each group's matrix, once it is needed
    SparsePattern pattern_;
    std::vector<std::int64_t> places_;  // of each value of the system's pattern
    std::unique_ptr<LinearSolver> solver_;
    std::vector<double> values_;         // with those of the blocks
    std::vector<double> system_values_;  // without
    std::vector<PairBlock> blocks_;      // in the axes of the unknowns
    std::unique_ptr<CouplingSolver> coupling_;
    bool is_stale_ = false;      // whether the pattern lacks groups
    bool is_iterative_ = false;  // the last factorization
    bool has_failed_ = false;    // iterations, in this step
    int orderings_ = 0;
};

}  // namespace gxrod
