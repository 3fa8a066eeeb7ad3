#pragma once

#include "assembly/system.hpp"
#include "linear/eigen/quadratic_problem.hpp"

namespace gxrod {

// The derivatives of the residual by small motions about a state, as values on the system's pattern. With x
// the displacements and spins (δr, δφ) of the nodes, the residual is to first order stiffness x + damping x′
// + mass x″ (docs/theory/vibrations.md, (V1)). Sections neither slip nor yield, and relaxing stiffness has
// relaxed.
struct StateMatrices {
    std::vector<double> stiffness;  // at unchanged spatial rates
    std::vector<double> damping;  // by v and ω: damping of materials, and gyroscopic terms if the state moves
    std::vector<double> mass;
    std::vector<RelaxingMatrix> relaxing{};  // additional stiffness for each relaxation time of sections

    // Returns the stiffness before anything relaxes.
    std::vector<double> instantaneous_stiffness() const;
    QuadraticProblem problem_on(const SparsePattern& pattern) const {
        return {&pattern, stiffness, damping, mass, relaxing};
    }
};

// Computes the matrices about the trial motions of an accepted state, with loads at `time`. Ignores
// resultants that the state holds.
StateMatrices compute_state_matrices(const System& system, const State& state, double time);

}  // namespace gxrod
