#pragma once

#include "linear/linear_solver.hpp"

namespace gxrod {

// Counts eigenvalues of symmetric pencils by the signs of pivots (Sylvester's law of inertia).
class EigenvalueCount {
  public:
    // The pattern must outlive this; `chains` counts best. `multipliers` is the number of negative
    // eigenvalues of multipliers, which no factor changes; they do not count.
    explicit EigenvalueCount(const SparsePattern& pattern,
                             const ThreadTeam& team = ThreadTeam::alone(),
                             std::int64_t multipliers = 0)
        : pattern_(&pattern),
          solver_(make_linear_solver(LinearSolverKind::chains, pattern, team)),
          multipliers_(multipliers) {}

    // Factorizes a + factor b: returns the number of its negative eigenvalues, or −1 if a pivot vanishes.
    std::int64_t factorize(const std::vector<double>& a, double factor, const std::vector<double>& b);
    // Does the same, with a neighbouring factor if a pivot vanishes.
    std::int64_t count(const std::vector<double>& a, double factor, const std::vector<double>& b);

    // The solver and the values of the last factorized matrix, until the next one.
    LinearSolver& solver() { return *solver_; }
    const std::vector<double>& values() const { return values_; }

  private:
    const SparsePattern* pattern_;
    std::unique_ptr<LinearSolver> solver_;
    std::int64_t multipliers_;
    std::vector<double> values_;
};

}  // namespace gxrod
