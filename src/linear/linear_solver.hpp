#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "linear/sparse_pattern.hpp"
#include "model/settings/settings.hpp"
#include "parallel/thread_team.hpp"

namespace gxrod {

struct Factorization {
    bool regular = true;
    std::int64_t singular_equation = -1;  // equation with the vanishing pivot, if known
    // For a symmetric matrix the number of its negative eigenvalues; for any other matrix only its parity
    // matters, the sign of the determinant. −1: not known, since the solver exchanged rows.
    std::int64_t negative_pivots = -1;
};

// A direct solver of sparse systems on one pattern: the symbolic work is done once. Each factorization finds
// its pivots anew, so that equal values give equal bits, independent of earlier systems.
class LinearSolver {
  public:
    virtual ~LinearSolver() = default;

    // Factorizes the matrix with these values on the pattern; they must stay unchanged until the last
    // solution.
    virtual Factorization factorize(const std::vector<double>& values) = 0;
    // Replaces the right-hand side by the solution, after a regular factorization.
    virtual void solve(Eigen::VectorXd& right_hand_side) = 0;
    // Estimates the operations of a factorization; 0 if not known.
    virtual double estimate_flops() const { return 0.0; }
    // The kind of this solver; never `automatic`.
    virtual LinearSolverKind kind() const = 0;
};

// Makes a solver; the pattern must outlive it. Throws std::runtime_error if memory does not suffice; so do
// its members. `automatic` takes `chains`, or make_general_solver if the pattern lacks entries of its
// diagonal; it depends on the pattern alone, so that a model is always solved in the same way. `chains` uses
// the team, whose number of threads does not change results.
std::unique_ptr<LinearSolver> make_linear_solver(LinearSolverKind kind,
                                                 const SparsePattern& pattern,
                                                 const ThreadTeam& team = ThreadTeam::alone());

// Makes KLU or UMFPACK, by the pattern.
std::unique_ptr<LinearSolver> make_general_solver(const SparsePattern& pattern);

}  // namespace gxrod
