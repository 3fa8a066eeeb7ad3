#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "assembly/system.hpp"
#include "integrators/integrator.hpp"
#include "solvers/equilibrium.hpp"
#include "solvers/paired_matrix.hpp"

// Stability of static equilibria: the number of negative pivots of their tangent (Sylvester's law of inertia:
// for a symmetric K it is the number of negative eigenvalues).
namespace gxrod {

// A change of the number of negative pivots between two load factors.
struct StabilityChange {
    double from = 0.0;
    double until = 0.0;
    std::int64_t before = 0;
    std::int64_t after = 0;
    std::string
        shape;  // the unstable shape, in the words of describe_weakness; "" if the model became stable
};

// Returns the reason why the pivots of this model's tangent do not count unstable shapes, as the beginning of
// a sentence: "load[0] follows its point". "" if they do: all loads have a potential, and contact has no
// friction.
std::string find_load_without_potential(const Model& model);

// Counts negative pivots at equilibria of one system.
class PivotCounter {
  public:
    // The system must outlive it.
    explicit PivotCounter(const System& system)
        : system_(&system), has_potential_(find_load_without_potential(system.model()).empty()) {}

    // Counts negative pivots of the consistent tangent at the trial motions, whose residual the workspace
    // has, at the load factor of `stage`; −1 if a pivot vanishes. Pivots that are negative by round-off alone
    // do not count: the diagonal is raised by 100 units of rounding, and shapes whose stiffness that hides
    // are left out.
    std::int64_t count(const Integrator& integrator,
                       const Stage& stage,
                       SolverWorkspace& workspace,
                       State& state);
    // Describes the softest shape there.
    std::string describe_shape(const Integrator& integrator,
                               const Stage& stage,
                               SolverWorkspace& workspace,
                               State& state);

  private:
    // Computes the tangent with `round_off` times each entry of the diagonal added to it; into
    // workspace.values, and into paired_ if rods touch each other.
    void compute_tangent(const Integrator& integrator,
                         const Stage& stage,
                         SolverWorkspace& workspace,
                         State& state,
                         double round_off);

    std::int64_t count_neutral(const SparsePattern& pattern,
                               const std::vector<double>& values,
                               const Residual& residual,
                               int count) const;

    const System* system_;
    bool has_potential_;
    std::unique_ptr<LinearSolver> chains_;  // if the run's solver exchanges rows; none before the first use
    std::unique_ptr<PairedMatrix> paired_;  // if rods touch each other; none before the first use
};

// Describes the changes and the end, a sentence each. Paths are recommended for models without contact.
std::vector<std::string> describe_stability(const std::vector<StabilityChange>& changes,
                                            std::int64_t pivots_at_end,
                                            double end,
                                            bool has_potential,
                                            bool has_contact);

}  // namespace gxrod
