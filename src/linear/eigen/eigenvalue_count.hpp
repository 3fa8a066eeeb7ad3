#pragma once

#include "linear/linear_solver.hpp"

namespace gxrod {

// Counts eigenvalues of symmetric pencils by the signs of pivots (Sylvester's law of inertia).
class EigenvalueCount {
  public:
    // The pattern must outlive it; it counts best by `chains`. So many negative eigenvalues are those of
    // multipliers, which no factor changes, and do not count.
    explicit EigenvalueCount(const SparsePattern& pattern,
                             const ThreadTeam& team = ThreadTeam::alone(),
                             std::int64_t multipliers = 0)
        : pattern_(&pattern),
          solver_(make_linear_solver(LinearSolverKind::chains, pattern, team)),
          multipliers_(multipliers) {}

    // Factorizes a + factor b: the number of its negative eigenvalues, or −1 if a pivot vanishes.
    std::int64_t factorize(const std::vector<double>& a, double factor, const std::vector<double>& b);
    // The same, with a factor next to it where a pivot vanishes.
    std::int64_t count(const std::vector<double>& a, double factor, const std::vector<double>& b);

    // Of the last matrix that was factorized, until the next.
    LinearSolver& solver() { return *solver_; }
    const std::vector<double>& values() const { return values_; }

  private:
    const SparsePattern* pattern_;
    std::unique_ptr<LinearSolver> solver_;
    std::int64_t multipliers_;
    std::vector<double> values_;
};

}  // namespace gxrod
