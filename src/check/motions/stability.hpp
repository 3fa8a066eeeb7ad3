#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "assembly/system.hpp"
#include "integrators/integrator.hpp"
#include "solvers/equilibrium.hpp"
#include "solvers/paired_matrix.hpp"

// Whether static equilibria are stable: the number of negative pivots of their tangent (Sylvester's law of
// inertia: of a symmetric K they count the negative eigenvalues).
namespace gxrod {

// Between two load factors the number of negative pivots changed.
struct StabilityChange {
    double from = 0.0;
    double until = 0.0;
    std::int64_t before = 0;
    std::int64_t after = 0;
    std::string shape;  // what gives way, as describe_weakness says it; "" where it became stable
};

// Why the pivots of this model's tangent do not count unstable shapes, as a sentence begins: "load[0] follows
// its point". "" if they do: all loads have a potential, and no contact rubs.
std::string find_load_without_potential(const Model& model);

// Counts negative pivots at equilibria of one system.
class PivotCounter {
  public:
    // The system must outlive it.
    explicit PivotCounter(const System& system)
        : system_(&system), has_potential_(find_load_without_potential(system.model()).empty()) {}

    // Of the consistent tangent of the trial motions, whose residual the workspace has, at the load factor of
    // `stage`, or −1 if a pivot vanishes. What round-off alone makes negative does not count: the diagonal is
    // raised by 100 units of rounding, and shapes are left out whose stiffness it hides.
    std::int64_t count(const Integrator& integrator,
                       const Stage& stage,
                       SolverWorkspace& workspace,
                       State& state);
    // What resists least there.
    std::string describe_shape(const Integrator& integrator,
                               const Stage& stage,
                               SolverWorkspace& workspace,
                               State& state);

  private:
    // With `round_off` times each entry of the diagonal added to it; into workspace.values, and with rods
    // that touch each other into paired_.
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
    std::unique_ptr<LinearSolver>
        chains_;  // where the run's solver exchanges rows; none before the first use
    std::unique_ptr<PairedMatrix> paired_;  // where rods touch each other; none before the first use
};

// The changes and the end in words, a sentence each. Paths go on where the model has no contact.
std::vector<std::string> describe_stability(const std::vector<StabilityChange>& changes,
                                            std::int64_t pivots_at_end,
                                            double end,
                                            bool has_potential,
                                            bool has_contact);

}  // namespace gxrod
