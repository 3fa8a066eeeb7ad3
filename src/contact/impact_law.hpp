#pragma once

#include "contact/contact_law.hpp"
#include "contact/place_force.hpp"

namespace gxrod {

// The normal force of a time step (docs/theory/contact.md, (C16)): (1 − θ) f̄ + θ λ(g), with the mean force
// f̄ = −(V(g) − V(g₀))/(g − g₀) from the gap at the step's start, and θ the dissipation. Since V is convex,
// the work on a gap is never more than the energy that V releases; for θ = 0 it is equal. Without inertia θ =
// 1. The force is multiplied by (1 − damping (g − g₀)), or 0 if that is negative, (C17): this factor
// dissipates for any step.
struct ImpactLaw {
    ContactLaw law{};
    double dissipation = 1.0;
    double gap_before = 0.0;  // g₀ > 0; without effect for θ = 1 without damping
    double damping = 0.0;     // per length
};

// Multiplies a force of a gap by the factor of damping.
NormalForce damp(const NormalForce& normal, double damping, double gap, double gap_before);

// Computes the force at a gap > 0.
NormalForce compute_impact_force(const ImpactLaw& law, double gap);

// Finds the gap of the curve's point with the same λ/κ − g/ĝ as a force and a gap that may be off the curve.
double find_gap_on_curve(const ImpactLaw& law, double force, double gap);

}  // namespace gxrod
