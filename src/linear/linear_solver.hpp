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
    std::int64_t singular_equation = -1;  // where the pivot vanished, if known
    // Of a symmetric matrix the number of its negative eigenvalues, of any other one its parity is that of
    // the determinant's sign. −1: not known, since the solver exchanged rows.
    std::int64_t negative_pivots = -1;
};

// A direct solver of sparse systems on one pattern: the symbolic work is done once, each
// factorization finds its pivots again, so that equal values give equal bits whatever was solved before.
class LinearSolver {
  public:
    virtual ~LinearSolver() = default;

    // Factorizes the matrix with these values on the pattern; they must stay as they are until it is solved.
    virtual Factorization factorize(const std::vector<double>& values) = 0;
    // Replaces the right-hand side by the solution. After a regular factorization only.
    virtual void solve(Eigen::VectorXd& right_hand_side) = 0;
    // Of a factorization, as far as it is known; else 0.
    virtual double estimate_flops() const { return 0.0; }
    // Which one it is; never `automatic`.
    virtual LinearSolverKind kind() const = 0;
};

// The pattern must outlive the solver. Throws std::runtime_error if memory does not suffice; so do its
// members. `automatic` takes `chains` unless the pattern lacks entries of its diagonal, then as
// make_general_solver; by the pattern alone, so that a model is always solved in the same way. Of the team,
// whose number of threads changes no result, `chains` makes use.
std::unique_ptr<LinearSolver> make_linear_solver(LinearSolverKind kind,
                                                 const SparsePattern& pattern,
                                                 const ThreadTeam& team = ThreadTeam::alone());

// KLU or UMFPACK, by the pattern.
std::unique_ptr<LinearSolver> make_general_solver(const SparsePattern& pattern);

}  // namespace gxrod
