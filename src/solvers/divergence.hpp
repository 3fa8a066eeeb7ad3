#pragma once

#include <optional>

#include "solvers/pseudo_step.hpp"

namespace gxrod {

// The motion by which a model leaves an equilibrium in pseudo-time.
struct Divergence {
    double rate = 0.0;       // x grows as exp(rate · pseudo-time)
    double stiffness = 0.0;  // least stiffness of pseudo-steps with one solution nearby
    Eigen::VectorXd shape;   // over the equations
};

// Adds up the sizes of the forces of loads, supports and the residual, over the length of the model. The
// stiffness of a shape is compared with the sum. The workspace has the residual of the trial.
double measure_load_stiffness(const System& system,
                              double time,
                              const SolverWorkspace& workspace,
                              const State& state);

// Returns whether the symmetric part of the consistent tangent K at the trial motions has an eigenvalue below
// `bound`, relative to the drag. Eigenvalues that are negative by round-off alone do not count.
bool is_softer_than(double bound, const System& system, double time, const PseudoDrag& drag, State& state);

// Finds the shape in which drag x′ = −K x grows fastest, at a rate above `least`; none if all shapes decay.
// Works for forces without potential, such as follower loads, currents and friction: if the symmetric part of
// K has no negative eigenvalue, nothing grows; else powers of (K + σ drag)⁻¹ show what does.
std::optional<Divergence> find_divergence(
    const System& system, double time, const PseudoDrag& drag, double least, State& state);

}  // namespace gxrod
