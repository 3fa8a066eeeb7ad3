#pragma once

#include "contact/contact_law.hpp"
#include "contact/place_force.hpp"

namespace gxrod {

// The normal force of a step of time (docs/theory/contact.md, (C16)): (1 − θ) f̄ + θ λ(g), with the mean force
// f̄ = −(V(g) − V(g₀))/(g − g₀) from the gap at the step's start, and θ the dissipation. Since V is convex,
// its work on a gap is never more than the energy V gives: for θ = 0 it is just that. Where nothing has
// inertia θ = 1. All of it is multiplied by (1 − damping (g − g₀)), and nothing where that is negative,
// (C17): what takes energy whatever the step.
struct ImpactLaw {
    ContactLaw law{};
    double dissipation = 1.0;
    double gap_before = 0.0;  // g₀ > 0; without effect for θ = 1 without damping
    double damping = 0.0;     // per length
};

// A force of a gap with the factor of damping.
NormalForce damp(const NormalForce& normal, double damping, double gap, double gap_before);

// Of a gap > 0.
NormalForce compute_impact_force(const ImpactLaw& law, double gap);

// The gap of the curve's point to which a force and a gap belong that need not be on it: where λ/κ − g/ĝ is
// the same.
double find_gap_on_curve(const ImpactLaw& law, double force, double gap);

}  // namespace gxrod
