#pragma once

#include <optional>

#include "solvers/pseudo_step.hpp"

namespace gxrod {

// How a model leaves an equilibrium in pseudo-time.
struct Divergence {
    double rate = 0.0;       // x grows as exp(rate · pseudo-time)
    double stiffness = 0.0;  // of pseudo-steps: above it each of them has one solution nearby
    Eigen::VectorXd shape;   // over the equations
};

// Adds up the sizes of the forces of loads and supports, and of what is out of balance, over the length of
// the model: what the stiffness of a shape is compared with. The workspace has the residual of the trial.
double measure_load_stiffness(const System& system,
                              double time,
                              const SolverWorkspace& workspace,
                              const State& state);

// Whether the symmetric part of the consistent tangent K at the trial motions has an eigenvalue below
// `bound`, relative to the drag. What round-off alone makes negative does not count.
bool is_softer_than(double bound, const System& system, double time, const PseudoDrag& drag, State& state);

// The shape in which drag x′ = −K x grows fastest, at a rate above `least`; none where all shapes decay.
// Loads that follow, currents and friction need no potential: where the symmetric part of K has no negative
// eigenvalue, nothing grows; else powers of (K + σ drag)⁻¹ show what does.
std::optional<Divergence> find_divergence(
    const System& system, double time, const PseudoDrag& drag, double least, State& state);

}  // namespace gxrod
