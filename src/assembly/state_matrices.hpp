#pragma once

#include "assembly/system.hpp"
#include "linear/eigen/quadratic_problem.hpp"

namespace gxrod {

// How the residual follows small motions about a state, as values on the system's pattern: with x the
// displacements and spins (δr, δφ) of the nodes, to first order stiffness x + damping x′ + mass x″
// (docs/theory/vibrations.md, (V1)). Sections neither slip nor yield, and what relaxes has relaxed.
struct StateMatrices {
    std::vector<double> stiffness;  // at unchanged spatial rates
    std::vector<double> damping;    // by v and ω: of materials, and gyroscopic where the state moves
    std::vector<double> mass;
    std::vector<RelaxingMatrix> relaxing{};  // stiffness in addition, for each relaxation time of sections

    // Before anything relaxes.
    std::vector<double> instantaneous_stiffness() const;
    QuadraticProblem problem_on(const SparsePattern& pattern) const {
        return {&pattern, stiffness, damping, mass, relaxing};
    }
};

// Of the trial motions of an accepted state, with loads at `time`. Resultants that the state holds are left
// aside.
StateMatrices compute_state_matrices(const System& system, const State& state, double time);

}  // namespace gxrod
